#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Runs an example that prints the same in every run: expected_output.sh PREFIX EXAMPLE
set -euo pipefail
diff -u "$2/expected_output.txt" <("$2/run" "$1" 2>&1)
