-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print(os.time({year = 2024, month = 5, day = 6, hour = 7, min = 8, sec = 9}))
print(os.date("!%Y-%m-%d %H:%M:%S", 86400), os.date("!*t", 0).year, os.date("!*t", 0).isdst)
print(os.difftime(10, 4), type(os.clock()), type(os.time()), os.getenv("NO_SUCH_VARIABLE"))
print(os.execute("exit 3"), os.execute("true"), type(os.execute()))
print(os.setlocale("C"), os.rename("/no/such/a", "/no/such/b"))
