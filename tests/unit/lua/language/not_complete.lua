-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
for i = 1, 3 do
    print(i)
