# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Proofs about types across plugins.
add_subdirectory(type_identity)
add_subdirectory(handwritten_typekit)
