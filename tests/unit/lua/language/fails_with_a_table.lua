-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local caught, what = pcall(error, {text = "in a table"})
print(caught, what.text)
error("at the end", 0)
