# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""The table behind check_layers.py: which folder is which layer, and who may include whom."""

import pathlib
import re

# Longest matching prefix wins; a file may be named to take it out of its folder's layer.
LAYER_OF = {
    "runtime/diag/": "diag",
    "runtime/files/": "files",
    "runtime/report/": "report",
    "runtime/xml/": "xml",
    "runtime/rtt/os/": "os",
    "runtime/rtt/rtt-config.h": "os",       # made by CMake from rtt-config.h.in
    "runtime/rtt/rtt-detail-fwd.hpp": "os",  # included by it
    "runtime/rtt/Time.hpp": "os",
    "runtime/rtt/os/Timer.cpp": "core",     # the thread of a timer is an activity
    "runtime/rtt/": "core",                 # rtt/, base/, internal/, types/: one library, API templates force that
    "runtime/rtt/RTT.hpp": "umbrella",      # what components include; nothing inside the runtime does
    "runtime/rtt/Component.hpp": "component",   # the macros that component libraries export themselves with
    "runtime/rtt/plugin/": "plugin",
    # The C interface of plugins: TypekitPlugin.hpp, core API, brings it along.
    "runtime/rtt/plugin/Plugin.hpp": "plugin_api",
    "runtime/rtt/plugin/c_linkage.hpp": "plugin_api",
    "runtime/rtt/plugin/version_guard.hpp": "plugin_api",
    "runtime/rtt/typekit/": "typekit",
    "runtime/rtt/extras/": "extras",
    # TaskContext and ExecutionEngine need these two, so they are built into core; only their paths say extras.
    "runtime/rtt/extras/SequentialActivity.": "core",
    "runtime/rtt/extras/SlaveActivity.": "core",
    "runtime/rtt/extras/slave_master.": "core",
    "runtime/cpf/": "cpf",                  # property files; built into the library of marsh
    "runtime/rtt/encoding/": "encoding",
    "runtime/rtt/marsh/": "marsh",
    "runtime/rtt/deployment/": "loader",
    "runtime/rtt/scripting/": "scripting",
    "runtime/rtt/scripting/detail/syntax/": "syntax",   # the grammar of scripts: no component, no type
    "runtime/rtt/transports/corba/": "corba",
    "runtime/rtt/transports/mqueue/": "mqueue",
    "ros/rtt_": "ros",
    "ros/std_msgs/": "ros",
    "deployer/ocl/": "ocl",
    "deployer/fbsched/": "ocl",             # <fbsched/fbsched.hpp>, a kept name
    "deployer/deployment/": "deployment",
    "deployer/console/": "console",
    # Text and files, without the runtime: what oro shows looks the same.
    "deployer/console/table.": "console_text",
    "deployer/console/theme.": "console_text",
    "deployer/console/history.": "console_text",
    "deployer/console/libedit_parts.": "console_text",
    "deployer/live/client/": "live_client",
    "deployer/live/door/": "live_door",
    "deployer/live/requests/": "live_requests",
    "deployer/live/rights.hpp": "live_rights",    # a struct that door and requests pass on
    "deployer/live/samples/": "live_samples",
    "deployer/live/server/": "live_server",
    "deployer/lua/": "lua",
    "deployer/reporting/": "reporting",
    "deployer/reporting/mcap/": "mcap",     # the file format alone
    "deployer/reporting/mcap_file/": "mcap_file",
    "deployer/reporting/report_file.": "mcap_file",     # also begins the files of other reporters
    "deployer/reporting/mcap_tool/": "mcap_tool",
    "deployer/reporting/schema/": "message_schema",     # what messages consist of, by the text in the file
    "deployer/replay/": "replay",
    "deployer/schedule/": "schedule",
    "deployer/logging/": "logging",
    "deployer/components/": "components",
    "deployer/chain/": "chain",
    "deployer/rt_check/": "rt_check",
    "deployer/bin/": "bin",
    "generator/model/": "model",
    "generator/manifest/": "manifest",
    "generator/adapters/": "adapters",
    "generator/clang/base/": "clang_base",
    "generator/clang/types/": "clang_types",
    "generator/clang/describe/": "clang_describe",
    "generator/clang/update/": "clang_update",
    "generator/check/": "check",
    "generator/merge/": "merge",
    "generator/flags/": "flags",
    "generator/view/": "view",
    "generator/render/": "render",
    "generator/emit/": "emit",
    "generator/emit/banner.": "banner",     # text that views put on top of generated files; writes nothing
    "generator/explain/": "explain",
    "generator/driver/": "driver",
    "typekit_gen/collect/": "collect",
    "typekit_gen/plan/": "plan",
    "typekit_gen/diff/": "plan",
    "typekit_gen/driver/": "typegen",
    "typekit_gen/messages/": "messages",     # of ROS: .msg and .srv files, no compiler
    "typekit_gen/ros_driver/": "typegen_ros",
    "templates/": "templates",
}

LEAFS = {"diag", "files", "xml"}
API = {"os", "core", "plugin_api", "component"}      # headers below every part around the core
RUNTIME = LEAFS | API | {"umbrella", "plugin", "typekit", "extras", "marsh", "loader", "scripting"}
GENERATOR = {"diag", "model", "manifest", "adapters", "clang_base", "clang_types", "check", "merge", "view", "render", "emit", "banner", "explain", "report", "flags"}
OUTER = LEAFS | API | {"plugin"}
DEPLOYER = RUNTIME | {"ocl"}
UMBRELLA = API | {"plugin", "extras", "loader", "typekit", "scripting", "marsh"}

# layer -> the other layers it may include
MAY_INCLUDE = {
    "diag": set(),
    "files": set(),
    "report": {"diag"},
    "xml": {"diag"},
    "os": set(),
    "plugin_api": {"os"},
    "core": LEAFS | {"os", "plugin_api"},
    "component": {"os", "core", "plugin_api"},
    "umbrella": UMBRELLA,
    "plugin": LEAFS | API,
    "typekit": OUTER,
    "extras": LEAFS | {"os", "core"},
    "cpf": OUTER,
    "encoding": LEAFS | {"os", "core"},
    "marsh": OUTER | {"cpf"},
    "loader": OUTER,
    "syntax": {"diag"},
    "scripting": OUTER | {"extras", "syntax"},
    "corba": OUTER | {"encoding"},
    "mqueue": OUTER | {"encoding"},
    "ros": OUTER | {"encoding", "marsh", "loader", "extras", "umbrella", "typekit", "scripting", "ocl", "deployment"},
    "ocl": API | {"umbrella", "plugin", "extras", "marsh", "loader"},
    "deployment": DEPLOYER | {"corba", "cpf"},
    "console": DEPLOYER | {"console_text"},
    "console_text": set(),
    "live_client": {"diag", "console_text", "mcap", "mcap_file"},
    "live_rights": set(),
    "live_requests": DEPLOYER | {"encoding", "console", "console_text", "live_rights"},
    "live_door": {"os", "live_rights"},     # in every deployment: neither JSON nor Beast
    "live_samples": DEPLOYER | {"encoding"},
    "live_server": DEPLOYER | {"encoding", "live_door", "live_requests", "live_rights", "live_samples"},
    "lua": DEPLOYER,
    "mcap": set(),
    "mcap_file": {"os", "mcap"},            # what recorders with and without the runtime write
    "message_schema": set(),
    "mcap_tool": {"diag", "mcap", "message_schema"},    # a program without the runtime
    "reporting": DEPLOYER | {"encoding", "mcap", "mcap_file"},
    "replay": DEPLOYER | {"encoding", "mcap", "message_schema"},
    "schedule": DEPLOYER | {"replay"},
    "logging": DEPLOYER,
    "components": DEPLOYER,
    "chain": DEPLOYER,
    "rt_check": set(),                      # preloaded: it must not bring the runtime along
    "bin": DEPLOYER | {"deployment", "console", "lua", "reporting", "replay", "schedule", "logging", "components", "chain", "rt_check", "corba", "report", "live_client", "live_door", "live_rights", "console_text"},
    "model": {"diag"},
    "manifest": LEAFS | {"model"},
    "adapters": LEAFS,
    "clang_base": {"diag", "model"},
    "clang_types": {"diag", "model", "adapters", "xml", "clang_base"},
    "clang_describe": {"diag", "model", "clang_base", "clang_types"},
    "clang_update": {"diag", "model", "clang_base"},
    "check": LEAFS | {"model"},
    "merge": {"diag", "model"},
    "flags": {"diag"},
    "banner": set(),
    "view": LEAFS | {"model", "banner"},
    "render": {"diag"},
    "emit": {"diag", "files", "banner"},
    "explain": {"diag"},
    "driver": GENERATOR | {"clang_describe", "clang_update", "xml"},     # typegen reads no components
    "collect": {"diag", "model", "flags"},
    "plan": {"diag", "model", "view", "render", "emit", "banner", "collect"},
    "messages": {"diag", "model", "render", "emit", "banner", "plan"},
    "typegen_ros": {"diag", "explain", "report", "render", "emit", "messages"},
    "typegen": GENERATOR | {"files", "collect", "plan", "messages"},
    # Text that ends up in the user's package: installed headers only.
    "templates": API | {"umbrella", "plugin", "typekit", "extras", "marsh", "loader", "scripting", "ocl", "ros"},
}

# Where <a/b.hpp> is looked for, in the order of the include path.
INCLUDE_ROOTS = ["runtime/", "deployer/", "generator/", "typekit_gen/", "ros/"]

# header name (regular expression, from the start) -> folders that alone may include it
FOREIGN = {
    r"(clang|llvm|clang-c|llvm-c)/": ["generator/clang/", "tests/fuzz/typegen/"],
    r"(omniORB4/|omniORB\.h|omnithread\.h|omniOR|CORBA\.h)": ["runtime/rtt/transports/corba/", "tests/unit/corba/"],
    r"mqueue\.h": ["runtime/rtt/transports/mqueue/", "deployer/rt_check/", "tests/unit/transports/", "bench/"],
    r"(lua5\.\d/)?(lua|lauxlib|lualib)\.h(pp)?": ["deployer/lua/"],
    r"log4cpp/": ["deployer/logging/", "deployer/ocl/", "deployer/bin/", "tests/unit/logging/", "bench/"],
    r"(zstd|lz4(frame|hc)?)\.h": ["deployer/reporting/mcap/"],
    r"netcdf(_\w+)?\.h$": ["deployer/reporting/netcdf_"],
    r"(histedit\.h|editline/|readline/)": ["deployer/console/", "deployer/live/client/"],
    r"(ros|roscpp|tf2?|actionlib|dynamic_reconfigure)/": ["ros/", "tests/unit/ros_", "bench/ros_"],
    # Of the runtime, what stays out of components and their libraries.
    r"nlohmann/": ["runtime/report/", "runtime/rtt/encoding/", "deployer/live/", "deployer/logging/", "generator/", "typekit_gen/", "tests/"],
    r"boost/(asio|beast)(/|\.hpp)": ["deployer/live/server/transport.cpp", "deployer/live/server/collecting_socket.hpp", "deployer/live/client/", "tests/unit/live/", "tests/fuzz/"],
    r"kainjow/": ["generator/render/"],
    r"CLI/": ["generator/driver/", "typekit_gen/driver/", "deployer/"],
    r"(gtest|gmock)/": ["tests/", "templates/", "examples/"],    # packages bring a test
    r"benchmark/": ["bench/"],
    # Every component translation unit would pay for these (mpl/bool.hpp: archives of boost.serialization must name it).
    r"boost/(fusion|mpl(?!/bool\.hpp)|spirit|phoenix|lambda)/": [],
}


def shared_headers():
    """Headers of the runtime that only its own parts share. The list stands where the others are installed."""
    text = (pathlib.Path(__file__).parent.parent / "cmake/CMakeLists.txt").read_text()
    names = re.search(r"set\(OROFORGE_SHARED_HEADERS\s([^)]*)\)", text).group(1).split()
    return [f"runtime/rtt/{name}.hpp" for name in names]


# Installed headers: a user's compiler must find all that they include.
INSTALLED = ["runtime/rtt/", "deployer/ocl/"]
NOT_INSTALLED = ["runtime/cpf/", "runtime/diag/", "runtime/files/", "runtime/report/", "runtime/xml/", "runtime/rtt/typekit/detail/", "deployer/deployment/",
                 "deployer/console/", "deployer/live/", "deployer/lua/", "deployer/reporting/", "deployer/replay/", "deployer/schedule/", "deployer/logging/",
                 "deployer/components/", "deployer/chain/", "deployer/rt_check/", "deployer/bin/", "generator/", "typekit_gen/",
                 *shared_headers()]

# Headers that include each other in a circle, because users get all of them from each: the classes of one circle refer
# to each other in templates.
CIRCLES = [
    {"runtime/rtt/Property.hpp", "runtime/rtt/PropertyBag.hpp"},
    {"runtime/rtt/InputPort.hpp", "runtime/rtt/OutputPort.hpp", "runtime/rtt/Service.hpp",
     "runtime/rtt/ServiceRequester.hpp", "runtime/rtt/internal/flow/ports_inl.hpp", "runtime/rtt/usual_includes.hpp"},
]

# "file that includes -> file included": known exceptions. Keep it short; each line says why.
ALLOWED = {
}


def main():
    import argparse

    import layer_graph

    parser = argparse.ArgumentParser(description="Draws this table. Arrows that others replace are left out.")
    form = parser.add_mutually_exclusive_group(required=True)
    form.add_argument("--dot", dest="draw", action="store_const", const=layer_graph.dot, help="for Graphviz")
    form.add_argument("--mermaid", dest="draw", action="store_const", const=layer_graph.mermaid, help="for Markdown")
    print(parser.parse_args().draw(LAYER_OF, MAY_INCLUDE))


if __name__ == "__main__":
    main()
