// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library that cannot be loaded: it needs a function that nobody has.
int functionThatNobodyHas();
extern "C" int useIt() { return functionThatNobodyHas(); }
