// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A program as users write it: the runtime is started before and stopped after it.
#include <rtt/RTT.hpp>
#include <rtt/os/main.h>

using namespace std;
using namespace RTT;
using namespace Orocos;

int check_after_umbrella();
int check_after_task_context();
int check_after_component();
int check_service_plugin();
int check_after_service();
int check_after_port();
int check_after_typekit_plugin();
int check_after_type_info();

int ORO_main(int argc, char* argv[]) {
    if (argc != 2 || string(argv[1]) != "argument" || __os_main_argc() != 2) return 101;
    Orocos::TaskContext task("task");
    if (int wrong = check_after_umbrella()) return wrong;
    if (int wrong = check_after_task_context()) return 20 + wrong;
    if (int wrong = check_after_component()) return 40 + wrong;
    if (int wrong = check_service_plugin()) return 60 + wrong;
    int (*const usual[])() = {check_after_service, check_after_port, check_after_typekit_plugin, check_after_type_info};
    for (int i = 0; i < 4; ++i)
        if (int wrong = usual[i]()) return 80 + 10 * i + wrong;
    log(Info) << "done" << endlog();
    cout << "all checked" << endl;
    return 0;
}
