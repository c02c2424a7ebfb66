// SPDX-License-Identifier: Apache-2.0
/// The pages of docs/tables that the rows refer to.
#pragma once

#include <vector>

#include "tb/claims/page.h"

namespace blysk::claims {

std::vector<table> article_tables();
std::vector<table> errata_tables();
std::vector<table> error_tables();
std::vector<table> energy_tables();
std::vector<table> angle_energy_tables();
std::vector<table> stability_tables();
std::vector<table> picture_tables();

}  // namespace blysk::claims
