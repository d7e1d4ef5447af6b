# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The grammar: no component takes part, so the sources are compiled in.
set(parser ${PROJECT_SOURCE_DIR}/runtime/rtt/scripting/detail/syntax)
file(GLOB parser_sources CONFIGURE_DEPENDS ${parser}/lexer.cpp ${parser}/parser.cpp ${parser}/parse_*.cpp)
oroforge_add_test(script_parser_test LIBS oroforge_diag INCLUDES ${PROJECT_SOURCE_DIR}/runtime
  SOURCES lexer_test.cpp parser_literal_test.cpp parser_expression_test.cpp parser_statement_test.cpp
    parser_definition_test.cpp parser_machine_test.cpp parser_place_test.cpp parser_error_test.cpp
    parser_limit_test.cpp ast_text.cpp ${parser_sources}
  DEFINITIONS SYNTAX_ERRORS_FILE="${CMAKE_CURRENT_LIST_DIR}/syntax_errors.txt" TIMEOUT 120)
oroforge_add_script_test(script_text_mate COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/text_mate_test.py
  ${PROJECT_SOURCE_DIR}/share/editors/ops.tmLanguage.json ${parser}/parse_tokens.cpp)
