# SPDX-License-Identifier: Apache-2.0
set(family specular)
