-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- rttros, and with a stand-in for its service.
local check = require("check")
local rttros = require("rttros")
require("rttlib")

local path, why = rttros.find_rospack("some_package")
check.equal(false, path)
-- With ROS, rtt_rospack finds no such package; without, there is no rtt_rospack.
check.yes(why:find("rtt_rospack", 1, true) or why:find("no ROS package 'some_package'", 1, true), why)
check.yes(rttros.rospack_find == rttros.find_rospack)
check.fails("text", rttros.find_rospack)

local provides = rtt.provides
local real = rtt.TaskContext.provides(rttlib.findpeer("zoo"))
rtt.provides = function(name)
   assert(name == "ros")
   return real
end
local zoo = rttlib.findpeer("zoo")
local find = rtt.Service.getOperation
rtt.Service.getOperation = function(service, name)
   assert(name == "find")
   return function(package) return package == "known" and "/opt/known" or "" end
end
local has = rtt.Service.hasOperation
rtt.Service.hasOperation = function() return true end
check.equal("/opt/known", rttros.find_rospack("known"))
path, why = rttros.find_rospack("unknown")
check.equal(false, path)
check.has("'unknown'", why)
rtt.provides, rtt.Service.getOperation, rtt.Service.hasOperation = provides, find, has

-- The program, by a stand-in.
local popen = io.popen
local asked
io.popen = function(command)
   asked = command
   return { read = function() return command:find("known") and "/opt/known" or nil end, close = function() end }
end
check.equal("/opt/known", rttros.find_rospack_roslua("known"))
check.has("rospack find known", asked)
check.fails("finds no package 'other'", rttros.find_rospack_roslua, "other")
io.popen = popen
check.fails("no name", rttros.find_rospack_roslua, "a; rm x")
check.fails("no name", rttros.find_rospack_roslua, nil)
check.done()
