-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- What there is, for people at a prompt.
local text = [=[
rttlib.color = true           texts in colour
values
  rtt_type(x)                 kind of userdata, or type
  var2tab(var)                a Variable as a table; also var:totab()
  varfromtab(var, tab)        assigns a table; also var:fromtab(tab)
  propfromtab(prop, tab), attrfromtab(attr, tab)
  vect2tab(var)               elements of a sequence
  ConnPolicy2tab(policy)      a policy with names in place of numbers
texts
  var2str(var), prop2str(prop), attr2str(attr), op2str(op), tc_op2str(tc, name), port2str(port [, nodoc])
  portval2str(port, tc), service2str(service), service_req2str(requester), tc2str(tc [, full])
  var_pp(var), pptc(tc), portstats(tc)        print; also tc:show()
components
  stat()                      prints all components; tc:stat() one
  info()                      prints services, typekits and types
  typekit_loaded(name)
  findpeer(name [, start])    a component, or false
  mappeers(func [, start])    calls a function for all components
interfaces
  create_if(iface [, tc])     makes ports, properties and attributes of a table
  tc_cleanup()                removes what Lua code gave to its component
  tc_has_port(tc, name), tc_has_property(tc, name), tc_has_attribute(tc, name)
  port_clone_conn(port [, suffix [, cname]])  a connected port of the other direction
  mirror(tc [, suffix [, tab]])               such ports for all ports
]=]

return { help = function() io.stdout:write(text) end }
