# SPDX-License-Identifier: Apache-2.0
blysk_specular_tests(quadratic)
