-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Where ROS packages are.
local rttlib = require("rttlib")

local rttros = {}

-- The global service `ros` can find packages once rtt_rospack is there.
local function finder()
   local known, ros = pcall(rtt.provides, "ros")
   if known and rtt.Service.hasOperation(ros, "find") then return rtt.Service.getOperation(ros, "find") end
end

local function importRospack()
   local deployer = rttlib.findpeer("Deployer") or rttlib.findpeer("deployer")
   if not deployer then return false, "there is no deployer to import rtt_rospack" end
   if not rtt.TaskContext.hasOperation(deployer, "import") then return false, "the deployer cannot import" end
   return rtt.TaskContext.getOperation(deployer, "import")("rtt_rospack"), "rtt_rospack cannot be imported; see the log"
end

--- The folder of a ROS package. Imports rtt_rospack if that is needed. False, and the reason, if it is not found.
function rttros.find_rospack(package)
   if type(package) ~= "string" then error("find_rospack: the name of a package is a text", 2) end
   local find = finder()
   if not find then
      local done, why = importRospack()
      find = done and finder()
      if not find then return false, why end
   end
   local path = find(package)
   if path == "" then return false, "there is no ROS package '" .. package .. "'" end
   return path
end
rttros.rospack_find = rttros.find_rospack

--- The same by the program `rospack`, without any plugin. An error if the package is not found.
function rttros.find_rospack_roslua(package)
   if type(package) ~= "string" or not package:match("^[%w_][%w_.-]*$") then
      error("find_rospack_roslua: '" .. tostring(package) .. "' is no name of a package", 2)
   end
   local pipe = io.popen("rospack find " .. package .. " 2>/dev/null")
   local path = pipe and pipe:read("*l")
   if pipe then pipe:close() end
   if not path or path == "" then error("rospack finds no package '" .. package .. "'", 2) end
   return path
end

return rttros
