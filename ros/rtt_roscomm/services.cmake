# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Services: what both plugins and generated ones use is in the library of topics.
oroforge_ros_unit(rtt_rostopic services
  service_codec.cpp service_form.cpp service_std_srvs.cpp service_server.cpp service_operation.cpp service_client.cpp
  service_part.cpp rosservice_proxy_base.cpp rosservice_signature.cpp rosservice_registry_service.cpp)

oroforge_ros_plugin(rtt_roscomm rtt_rosservice rosservice_plugin.cpp)
target_link_libraries(rtt_rosservice PRIVATE rtt_rostopic)
oroforge_ros_plugin(rtt_roscomm rtt_rosservice_registry rosservice_registry_plugin.cpp)
target_link_libraries(rtt_rosservice_registry PRIVATE rtt_rostopic)
