// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "live_window.hpp"

#include "../deployment/report.hpp"
#include "../live/door/door.hpp"
#include "../live/door/module.hpp"
#include "../live/door/token.hpp"
#include "../live/door/unix_address.hpp"
#include "../live/door/web_address.hpp"

#include <rtt/Logger.hpp>
#include <rtt/internal/located_log.hpp>
#include <rtt/plugin/shared_library.hpp>

#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

namespace OCL::deploy {

namespace diag = oroforge::diag;

namespace {

void reportAt(const std::string& file, diag::Severity severity, const char* code, const std::string& message) {
    diag::Sink sink;
    diag::Diagnostic made;
    made.severity = severity;
    made.code = code;
    made.where.file = file;
    made.message = message;
    sink.add(std::move(made));
    report(sink);
}

/** A second descriptor, which programs that components start do not inherit: they would keep the socket open. */
int another(const live::DoorSocket& socket) { return ::fcntl(socket.get(), F_DUPFD_CLOEXEC, 0); }

/** The module is beside the runtime's library, in a folder where nobody looks for libraries. */
std::string moduleFile() {
    const std::string runtime = RTT::plugin::SharedLibrary::fileWith(
        reinterpret_cast<const void*>(&RTT::internal::logLocated));  // any function of it
    return runtime.substr(0, runtime.rfind('/') + 1) + "oroforge/liborocos-ocl-live-" OROCOS_TARGET_NAME ".so";
}

live::RunningServer* serve(const live::ServerStart& start, std::string& error) {
    using RTT::plugin::SharedLibrary;
    SharedLibrary module(moduleFile(), SharedLibrary::Local, error);
    auto* const begin = module ? module.function<decltype(oroLiveServe)>("oroLiveServe") : nullptr;
    if (!begin) {
        if (module) error = "it is of another version";
        for (const int given : {start.local, start.client, start.web}) (void)live::Descriptor(given);
        return nullptr;
    }
    // Threads of components may be in it for longer than the server exists.
    module.keep();
    return begin(start, error);
}

}  // namespace

struct LiveWindow::Impl {
    explicit Impl(const Options& from) : options(from) {}

    /** Everything but the sockets. */
    live::ServerStart start() const {
        live::ServerStart result;
        result.deployer = deployer;
        result.name = options.name;
        result.version = programVersion();
        result.files = options.files;
        result.started = started;
        // As if somebody had sent it.
        result.stop = [] { (void)::kill(::getpid(), SIGTERM); };
        return result;
    }

    void listenLocally();
    bool listenToWeb();
    void letIn(live::Descriptor client);

    const Options options;
    const std::int64_t started =
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
            .count();
    DeploymentComponent* deployer = nullptr;
    std::optional<live::SocketFolder> folder;
    std::optional<live::DoorSocket> socket;
    live::WebAddress address;
    live::Descriptor web;
    std::string token;
    bool failed = false;
    std::unique_ptr<live::RunningServer> server;  // made by the thread of the door
    std::optional<live::Door> door;               // its thread ends before anything else does
};

void LiveWindow::Impl::listenLocally() {
    live::SocketFolder::Fault fault;
    folder.emplace(live::SocketFolder::usual(), fault);
    if (!*folder) {
        if (fault.isForeign)
            reportAt(folder->path(), diag::Severity::Warning, "WEB002",
                     fault.text + "; there is no live window, 'oro' cannot connect");
        else
            RTT::log(RTT::Info) << "there is no live window: " << folder->path() << ": " << fault.text << RTT::endlog();
        return;
    }
    folder->removeStale();
    std::string error;
    socket.emplace(*folder, live::socketName(options.name), error);
    if (*socket) return;
    socket.reset();
    RTT::log(RTT::Info) << "there is no live window: " << folder->path() << ": " << error << RTT::endlog();
}

bool LiveWindow::Impl::listenToWeb() {
    std::string error;
    if (!live::parseWebAddress(options.webAddress, address, error)) {
        reportAt("--web", diag::Severity::Error, "WEB003", error);
        return false;
    }
    if (!address.isLoopback() && options.webTokenFile.empty()) {
        reportAt("--web", diag::Severity::Error, "WEB004",
                 "others can reach the address '" + address.host + "'; name the file of a token by --web-token-file");
        return false;
    }
    token = options.webTokenFile.empty() ? live::newToken() : live::readToken(options.webTokenFile, error);
    if (token.empty()) {
        reportAt(options.webTokenFile.empty() ? "--web" : options.webTokenFile, diag::Severity::Error, "WEB005",
                 error.empty() ? "the kernel gives no random numbers" : error);
        return false;
    }
    web = live::listenAt(address, error);
    if (web) return true;
    reportAt("--web", diag::Severity::Error, "WEB001",
             "cannot listen at " + address.text() + ": " + error + "; choose another port by --web=" + address.host +
                 ":PORT, 0 for any that is free");
    return false;
}

void LiveWindow::Impl::letIn(live::Descriptor client) {
    live::ServerStart how = start();
    how.client = client.release();
    how.local = another(*socket);
    std::string error;
    server.reset(serve(how, error));
    if (server) return;
    RTT::log(RTT::Error) << "the live window does not open: " << error << RTT::endlog();
    socket.reset();  // nobody waits in vain
}

LiveWindow::LiveWindow(const Options& options) : impl_(new Impl(options)) {
    if (options.endsAtOnce()) return;
    if (options.live) impl_->listenLocally();
    if (!options.webAddress.empty()) impl_->failed = !impl_->listenToWeb();
}

LiveWindow::~LiveWindow() = default;

void LiveWindow::close() {
    impl_->door.reset();
    impl_->server.reset();
}

bool LiveWindow::failed() const { return impl_->failed; }

bool LiveWindow::open(DeploymentComponent& deployer) {
    impl_->deployer = &deployer;
    if (!impl_->web) {
        if (impl_->socket)
            impl_->door.emplace(impl_->socket->get(),
                                [this](live::Descriptor client) { impl_->letIn(std::move(client)); });
        return true;
    }
    live::ServerStart how = impl_->start();
    how.local = impl_->socket ? another(*impl_->socket) : -1;
    how.web = impl_->web.release();
    how.webAddress = impl_->address.text();
    how.webIsLoopback = impl_->address.isLoopback();
    how.token = impl_->token;
    how.webMay = impl_->options.webMay;
    how.webOrigins = impl_->options.webOrigins;
    std::string error;
    impl_->server.reset(serve(how, error));
    if (!impl_->server) {
        reportAt("--web", diag::Severity::Error, "WEB006", "the server does not start: " + error);
        return false;
    }
    const bool isOwn = impl_->options.webTokenFile.empty();
    std::cout << "live window: ws://" << how.webAddress << "/" << (isOwn ? "?token=" + how.token : "") << std::endl;
    return true;
}

}  // namespace OCL::deploy
