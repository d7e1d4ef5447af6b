-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local solutions, rows = 0, {}
local function free(column, row)
    for other, r in ipairs(rows) do if r == row or math.abs(r - row) == column - other then return false end end
    return true
end
local function place(column)
    if column > 6 then solutions = solutions + 1; print(table.concat(rows, " ")); return end
    for row = 1, 6 do
        if free(column, row) then rows[column] = row; place(column + 1); rows[column] = nil end
    end
end
place(1)
print(solutions)
