# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Launch files, and what roslaunch and rosrun find in lib/rtt_ros: a script for each program.
set(folder ${PROJECT_BINARY_DIR}/lib/rtt_ros)
set(scripts "")
# The name of a script says which program it runs: <program>, <program>-debug.
foreach(name deployer deployer-corba deployer-debug deployer-corba-debug rttscript rttlua rttlua-tlsf rttlua-debug
    orocreate-pkg typegen orogen orogen-unregister rtt-upgrade-2.5 corba-naming-service)
  configure_file(scripts/program.in ${folder}/${name} @ONLY FILE_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  list(APPEND scripts ${folder}/${name})
endforeach()
foreach(name ldeployer ldeployer-corba ldeployer-debug ldeployer-corba-debug)
  configure_file(scripts/ldeployer ${folder}/${name} COPYONLY)
  list(APPEND scripts ${folder}/${name})
endforeach()
configure_file(scripts/rttlua-screen ${folder}/rttlua-screen COPYONLY)
list(APPEND scripts ${folder}/rttlua-screen)
install(PROGRAMS ${scripts} DESTINATION lib/rtt_ros COMPONENT ros)

foreach(file deployer rttlua ldeployer)
  configure_file(launch/${file}.launch ${PROJECT_BINARY_DIR}/share/rtt_ros/launch/${file}.launch COPYONLY)
endforeach()
install(DIRECTORY launch DESTINATION share/rtt_ros COMPONENT ros)

# The mark of a prefix whose lib/<package> roslaunch and rosrun search; they search /usr without one.
file(WRITE ${PROJECT_BINARY_DIR}/.catkin "")
install(CODE "
  if(NOT \"\${CMAKE_INSTALL_PREFIX}\" STREQUAL \"/usr\" AND NOT EXISTS \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/.catkin\")
    file(WRITE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/.catkin\" \"\")
  endif()" COMPONENT ros)
