-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print(("abc"):upper(), ("ABC"):lower(), ("abc"):reverse(), ("abc"):len(), #"a\0b", ("ab"):rep(3))
print(("hello"):sub(2, 4), ("hello"):sub(-3), ("hello"):sub(2), ("hello"):sub(4, 2) == "", ("hello"):sub(-100, 100))
print(("abc"):byte(1, -1), string.char(72, 105), ("x"):byte(10))
print(string.format("%5d|%-5d|%05d|%+d|%x|%X|%o|%c", 42, 42, 42, 42, 255, 255, 8, 65))
print(string.format("%s %q %10s|%-10s|%.2s", "text", 'a "b"\n\\', "r", "l", "cut"))
print(string.format("%%"), pcall(string.format, "%d", "x"))
print("\65\066\10067", 'tab\tend', [[long
string]], [==[with ]] in it]==])
print("10" + 5, "0x10" + 0, 10 .. 20, tostring(nil), tostring(true))
