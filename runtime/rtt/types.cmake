# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Types, data sources, properties.
target_sources(orocos-rtt PRIVATE
  rtt/Attribute.cpp
  rtt/Property.cpp
  rtt/PropertyBag.cpp
  rtt/base/ActionInterface.cpp
  rtt/base/DataSourceBase.cpp
  rtt/base/PropertyBase.cpp
  rtt/internal/DataSources.cpp
  rtt/internal/values/newer_properties.cpp
  rtt/internal/values/value_place.cpp
  rtt/internal/values/property_paths.cpp
  rtt/internal/values/property_update.cpp
  rtt/types/ErasedFunction.cpp
  rtt/types/GlobalsRepository.cpp
  rtt/types/MessageNames.cpp
  rtt/types/Operators.cpp
  rtt/types/PropertyComposition.cpp
  rtt/types/Schema.cpp
  rtt/types/SizeLimit.cpp
  rtt/types/SequenceMembers.cpp
  rtt/types/StructMembers.cpp
  rtt/types/TemplateConstructor.cpp
  rtt/types/TypeInfo.cpp
  rtt/types/TypeInfoRepository.cpp
  rtt/types/TypekitRepository.cpp
  rtt/types/factories.cpp
  rtt/types/shape.cpp
  rtt/types/fundamental_arrays.cpp
  rtt/types/type_values.cpp
  rtt/types/composition.cpp
  rtt/types/detail/adapted_table.cpp
  rtt/types/detail/enum_constructors.cpp
  rtt/types/detail/enum_table.cpp
  rtt/types/detail/generated_typekit.cpp
  rtt/types/detail/sequence_constructor.cpp
  rtt/types/detail/sequence_table.cpp
  rtt/types/detail/shown_table.cpp
  rtt/types/detail/struct_table.cpp
  rtt/types/detail/table_generator.cpp
  rtt/types/detail/variant_table.cpp
  rtt/types/detail/type_names.cpp)
