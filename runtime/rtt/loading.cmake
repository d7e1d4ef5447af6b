# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Plugin and component loader.
target_sources(orocos-rtt PRIVATE
  rtt/deployment/ComponentLoader.cpp
  rtt/deployment/component_factories.cpp
  rtt/deployment/deployed_texts.cpp
  rtt/deployment/detail/component_library.cpp
  rtt/deployment/detail/component_table.cpp
  rtt/deployment/detail/deferred_libraries.cpp
  rtt/deployment/detail/listed_types.cpp
  rtt/deployment/detail/package_import.cpp
  rtt/deployment/ros_packages.cpp
  rtt/deployment/startup.cpp
  rtt/internal/ComponentDescription.cpp
  rtt/plugin/PluginLoader.cpp
  rtt/plugin/detail/plugin_table.cpp
  rtt/plugin/detail/needed_library.cpp
  rtt/plugin/search_path.cpp
  rtt/plugin/shared_library.cpp
  rtt/plugin/detail/trusted_file.cpp)
