-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- A stand-in for rFSM: flat machines, one event a transition.
local rfsm = {}

function rfsm.state(tab) return tab end
function rfsm.trans(tab) return tab end
function rfsm.load(file) return dofile(file) end

function rfsm.init(machine)
   if type(machine) ~= "table" then return false end
   local fsm = { machine = machine, queue = {}, hooks = {} }
   fsm.getevents = machine.getevents
   fsm._act_leaf = { _fqn = "root." .. machine.initial }
   return fsm
end

function rfsm.send_events(fsm, ...)
   for _, event in ipairs({ ... }) do table.insert(fsm.queue, event) end
end

function rfsm.post_step_hook_add(fsm, hook) table.insert(fsm.hooks, hook) end

function rfsm.run(fsm)
   for _, event in ipairs(fsm.getevents and fsm.getevents() or {}) do table.insert(fsm.queue, event) end
   local done = #fsm.queue == 0
   while not done do
      local event = table.remove(fsm.queue, 1)
      for _, trans in ipairs(fsm.machine.trans) do
         if trans.event == event and "root." .. trans.src == fsm._act_leaf._fqn then
            fsm._act_leaf = { _fqn = "root." .. trans.tgt }
            if fsm.machine.entered then fsm.machine.entered(trans.tgt) end
            break
         end
      end
      done = #fsm.queue == 0
   end
   for _, hook in ipairs(fsm.hooks) do hook(fsm) end
end

return rfsm
