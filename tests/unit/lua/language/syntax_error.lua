-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print("never")
local x = = 2
