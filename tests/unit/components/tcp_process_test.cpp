// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// TcpReporting in a deployer, read by a program in Python, and ended while that is connected.
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <string>

namespace {

using namespace oroforge::test;
using std::chrono::seconds;

const char* const kApplication = R"(
import("reporttest")
import("ocl")
loadComponent("counter", "reporttest::Counter")
loadComponent("reporter", "OCL::TcpReporting")
loadService("Deployer", "os")
loadService("Deployer", "print")
setActivity("counter", 0.001, 0, 0)
setActivity("reporter", 0.001, 0, 0)
addPeer("reporter", "counter")
reporter.port = 0
counter.configure() && counter.start()
reporter.reportComponent("counter")
reporter.configure() && reporter.start()
os.execute("echo " + reporter.used_port + " > port")
print.ln("ready")
)";

const char* const kClient = R"(
import socket, sys
connection = socket.create_connection(("127.0.0.1", int(sys.argv[1])), 20)
lines = connection.makefile("r", newline="\n")
def ask(command):
    connection.sendall((command + "\r\n").encode())
    return lines.readline().rstrip("\n")
print(lines.readline().rstrip("\n"))
print(ask("version 1.0"))
print(ask("SUBSCRIBE counter.n0"))
values = []
# A computer that is busy may let the reporter catch up with many rows before the counter goes on.
while len(values) < 200 or values[-1] == values[0]:
    number = len(values)
    frame = [lines.readline().rstrip("\n") for _ in range(4)]
    assert frame[0] == f"201 {number} -- begin of frame", frame
    assert frame[1] == "202 counter.n0" and frame[3] == f"203 {number} -- end of frame", frame
    values.append(float(frame[2].split(" ")[1]))
assert values == sorted(values) and values[-1] > values[0], values
print("200 frames", flush=True)
if "stay" in sys.argv:
    rest = frame[3:] + lines.readlines()  # to the end of the connection
    print("last:", rest[-1].split(" ", 2)[2].rstrip("\n"))
else:
    connection.sendall(b"QUIT\r\n")
    print("last:", ("\n" + lines.read()).rsplit("\n", 1)[1])
)";

class TcpReporter : public testing::Test {
protected:
    void SetUp() override { directory_.write("client.py", kClient); }
    Command deployer() {
        directory_.write("app.ops", kApplication);
        Command command;
        command.program = DEPLOYER_PROGRAM;
        command.arguments = {"-s", "app.ops"};
        command.inputStaysOpen = true;
        command.directory = directory_.path();
        command.environment = {{"RTT_COMPONENT_PATH", OCL_TEST_PATH}};
        command.timeout = seconds(40);
        return command;
    }
    Command client(const std::string& mode) {
        Command command;
        command.program = "/usr/bin/python3";
        command.arguments = {"client.py", readFile(directory_ / "port"), mode};
        command.directory = directory_.path();
        command.timeout = seconds(30);
        return command;
    }

    TempDir directory_;
};

TEST_F(TcpReporter, ServesProgramsUntilItEnds) {
    ChildProcess child(deployer());
    ASSERT_TRUE(child.waitForOutput("ready", seconds(30))) << child.finish().err;
    const std::string greeting = "100 Orocos 1.0 TcpReporting Server 1.0\n101 OK\n302 counter.n0\n200 frames\n";
    const Outcome quitting = run(client("quit"));
    EXPECT_EQ(0, quitting.status) << quitting.err;
    EXPECT_EQ(greeting + "last: 104 Bye bye\n", quitting.out);
    ChildProcess staying(client("stay"));
    EXPECT_TRUE(staying.waitForOutput("200 frames", seconds(20)));
    child.send(SIGTERM);
    const Outcome deployed = child.finish();
    EXPECT_EQ(0, deployed.status) << deployed.err;
    const Outcome stayed = staying.finish();
    EXPECT_EQ(0, stayed.status) << stayed.err;
    EXPECT_EQ(greeting + "last: -- end of frame\n", stayed.out);
}

}  // namespace
