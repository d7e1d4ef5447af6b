// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/ApplicationServer.hpp>

#include <rtt/Logger.hpp>
#include <rtt/transports/corba/detail/end_point.hpp>
#include <rtt/transports/corba/detail/later.hpp>
#include <rtt/transports/corba/detail/orb_run.hpp>
#include <rtt/transports/corba/detail/thread_settings.hpp>
#include <rtt/transports/corba/detail/watch.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace RTT::corba {

CORBA::ORB_var ApplicationServer::orb;
PortableServer::POA_var ApplicationServer::rootPOA;

namespace {

/** What the command line and the environment say about the ORB. Its own defaults are for whatever they leave open. */
class OrbOptions {
public:
    OrbOptions(int argc, char* argv[]) : arguments_(argv, argv + argc), file_(settingsIn(fileName())) {}

    bool has(const std::string& option) const { return !given(option).empty(); }
    /** All values that an option is given, whichever of them count. */
    std::vector<std::string> given(const std::string& option) const {
        std::vector<std::string> all;
        if (const char* const fromEnvironment = std::getenv(("ORB" + option).c_str())) all.push_back(fromEnvironment);
        for (std::size_t i = 0; i != arguments_.size(); ++i)
            if (arguments_[i] == "-ORB" + option) all.push_back(i + 1 != arguments_.size() ? arguments_[i + 1] : "");
        for (const auto& [name, value] : file_)
            if (name == option) all.push_back(value);
        return all;
    }
    /** The naming service's host, if it is known. */
    std::string nameServiceHost() const {
        for (const std::string& argument : arguments_)
            if (argument.compare(0, 12, "NameService=") == 0) return detail::hostOfReference(argument);
        if (const char* const fromEnvironment = std::getenv("ORBInitRef"))
            return detail::hostOfReference(fromEnvironment);
        for (const auto& [name, value] : file_)
            if (name == "InitRef" && value.compare(0, 12, "NameService=") == 0) return detail::hostOfReference(value);
        return {};
    }
    void setDefault(const std::string& option, const std::string& value) {
        if (!has(option)) defaults_.emplace_back(option, value);
    }
    const std::vector<std::pair<std::string, std::string>>& defaults() const { return defaults_; }

private:
    typedef std::vector<std::pair<std::string, std::string>> Settings;

    /** The file that omniORB reads. */
    std::string fileName() const {
        const auto given = std::find(arguments_.begin(), arguments_.end(), "-ORBconfigFile");
        if (given != arguments_.end() && given + 1 != arguments_.end()) return *(given + 1);
        const char* const fromEnvironment = std::getenv("OMNIORB_CONFIG");
        return fromEnvironment ? fromEnvironment : "/etc/omniORB.cfg";
    }
    /** Its lines "name = value". */
    static Settings settingsIn(const std::string& file) {
        Settings all;
        std::ifstream lines(file);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string name, equals, value;
            if (words >> name >> equals >> value && name[0] != '#' && equals == "=") all.emplace_back(name, value);
        }
        return all;
    }

    const std::vector<std::string> arguments_;
    const Settings file_;
    std::vector<std::pair<std::string, std::string>> defaults_;
};

/** Other computers can connect if the naming service is on one of them. */
void chooseEndPoint(OrbOptions& options) {
    if (options.has("endPoint")) return;
    const std::string host = options.nameServiceHost();
    const std::string address = host.empty() ? std::string() : detail::addressTowards(host);
    if (address.empty() || detail::isLoopback(address)) return options.setDefault("endPoint", "giop:tcp:127.0.0.1:");
    options.setDefault("endPoint", "giop:tcp:" + address + ":");
    log(Info) << "the naming service is on " << host << ", so other computers can connect to " << address << endlog();
}

/** An end point that is given twice is none that may be trusted, so all of them count. */
bool areLocal(const OrbOptions& options) {
    std::vector<std::string> all = options.given("endPoint");
    for (const std::string& one : options.given("endPointNoPublish")) all.push_back(one);
    for (const auto& [name, value] : options.defaults())
        if (name == "endPoint") all.push_back(value);
    return std::all_of(all.begin(), all.end(), detail::isLocalEndPoint);
}

std::string milliseconds(Seconds time) { return std::to_string(static_cast<long>(time * 1000)); }

CORBA::ORB_ptr makeOrb(int& argc, char* argv[], const OrbOptions& options) {
    typedef const char* Option[2];
    std::vector<const char*> flat;
    for (const auto& [name, value] : options.defaults()) {
        flat.push_back(name.c_str());
        flat.push_back(value.c_str());
    }
    flat.push_back(nullptr);
    flat.push_back(nullptr);
    return CORBA::ORB_init(argc, argv, "omniORB4", reinterpret_cast<Option*>(flat.data()));
}

/** For programs that end without DestroyOrb(): omniORB is taken apart soon. */
void endThreads() {
    detail::endWatches();
    detail::endLater();
}

}  // namespace

bool ApplicationServer::InitOrb(int argc, char* argv[], Seconds orb_timeout) {
    const Logger::In in("ApplicationServer");
    if (!CORBA::is_nil(orb)) return false;
    OrbOptions options(argc, argv);
    chooseEndPoint(options);
    options.setDefault("giopMaxMsgSize", "268435456");       // samples may be large
    options.setDefault("maxGIOPConnectionPerServer", "50");  // calls that wait do not hold up others
    options.setDefault("clientConnectTimeOutPeriod",
                       "3000");  // ms; an unreachable computer is none for minutes otherwise
    options.setDefault("nativeCharCodeSet", "ISO-8859-1");
    if (orb_timeout > 0) options.setDefault("clientCallTimeOutPeriod", milliseconds(orb_timeout));
    try {
        orb = makeOrb(argc, argv, options);
        detail::setUpOrbThreads();  // before the root POA, which makes the first one
        const CORBA::Object_var object = orb->resolve_initial_references("RootPOA");
        rootPOA = PortableServer::POA::_narrow(object);
        const PortableServer::POAManager_var manager = rootPOA->the_POAManager();
        detail::setOthersCanConnect(!areLocal(options));
        manager->activate();
        detail::beginRun();
        static const int ended = std::atexit(&endThreads);
        (void)ended;
        return true;
    } catch (const CORBA::Exception& error) {
        log(Error) << "the ORB cannot be started: " << error._name()
                   << "; the arguments after -- are those of omniORB, such as -ORBInitRef NameService=…" << endlog();
    }
    orb = CORBA::ORB::_nil();
    rootPOA = PortableServer::POA::_nil();
    return false;
}

}  // namespace RTT::corba
