// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component and its life cycle. report_entries.cpp selects what is reported, running_report.cpp writes rows.
#include <ocl/ReportingComponent.hpp>

#include "reporting_state.hpp"

#include <rtt/Logger.hpp>

#include <limits>

namespace OCL {

using reporting::Decomposition;
using reporting::Report;
using reporting::RunningReport;
using RTT::endlog;
using RTT::log;

namespace {

/** The most rows written in one cycle, so that a writer that never pauses cannot prevent a stop. */
constexpr int kRowsPerCycle = 10000;

}  // namespace

ReportingComponent::ReportingComponent(std::string name) : RTT::TaskContext(name), impl_(new Impl(*this)) {
    addProperty("WriteHeader", impl_->writeHeader).doc("Begin the report with a line of column names.");
    addProperty("RepeatHeader", impl_->repeatHeader)
        .doc("Write that line again when there are more columns, because a sequence has grown.");
    addProperty("Decompose", impl_->decompose).doc("Give each member and element of a value a column of its own.");
    addProperty("ComplexDecompose", impl_->complexDecompose)
        .doc("Take values apart as in property files. Decompose must be set, too. Allocates memory.");
    addProperty("Snapshot", impl_->snapshotOnly)
        .doc("Without a periodic activity: write a row when snapshot() is called only, not when data comes.");
    addProperty("Synchronize", impl_->synchronize)
        .doc("Time stamps count from the beginning of the log, not from the start of this component.");
    addProperty("ReportData", impl_->reportData)
        .doc(
            "What to report: strings named Component, Port or Data, with values like Robot, Robot.port, "
            "Robot.property.");
    addProperty("ReportPolicy", impl_->policy).doc("The connection policy of the ports that are reported.");
    addProperty("ReportOnlyNewData", impl_->onlyNewData)
        .doc("Leave out of a row what has not changed since the last one.");
    addProperty("Precision", impl_->precision).doc("Digits of numbers with a fraction.");
    addAttribute("LostRows", impl_->lostRows);

    addOperation("snapshot", &ReportingComponent::snapshot, this, RTT::OwnThread)
        .doc("Writes a row now, if the activity is not periodic.");
    addOperation("screenComponent", &ReportingComponent::screenComponent, this)
        .doc("Writes down the interface of a peer as it is now.")
        .arg("Component", "Name of the peer");
    addOperation("reportComponent", &ReportingComponent::reportComponent, this)
        .doc("Adds all output ports of a peer.")
        .arg("Component", "Name of the peer");
    addOperation("unreportComponent", &ReportingComponent::unreportComponent, this)
        .doc("Removes everything of a peer.")
        .arg("Component", "Name of the peer");
    addOperation("reportData", &ReportingComponent::reportData, this)
        .doc("Adds a property or attribute of a peer.")
        .arg("Component", "Name of the peer")
        .arg("Data", "Name of the property or attribute");
    addOperation("unreportData", &ReportingComponent::unreportData, this)
        .doc("Removes a property or attribute.")
        .arg("Component", "Name of the peer")
        .arg("Data", "Name of the property or attribute");
    addOperation("reportPort", &ReportingComponent::reportPort, this)
        .doc("Adds an output port of a peer.")
        .arg("Component", "Name of the peer")
        .arg("Port", "Name of the port, with its services: service.port");
    addOperation("unreportPort", &ReportingComponent::unreportPort, this)
        .doc("Removes a port.")
        .arg("Component", "Name of the peer")
        .arg("Port", "Name of the port, with its services: service.port");
}

ReportingComponent::~ReportingComponent() {
    stopForGood();
    impl_->sources.clear();  // removes their ports from this component before it is destroyed
}

bool ReportingComponent::addMarshaller(RTT::marsh::MarshallInterface* header, RTT::marsh::MarshallInterface* body) {
    if (!header && !body) return false;
    reporting::Marshallers added;
    added.header.reset(header);
    added.body.reset(body);
    impl_->marshallers.push_back(std::move(added));
    return true;
}

bool ReportingComponent::removeMarshallers() {
    impl_->marshallers.clear();
    return true;
}

void ReportingComponent::writeTo(std::unique_ptr<reporting::RowSink> sink) { impl_->sink = std::move(sink); }
void ReportingComponent::reportBy(ReportMaker maker) { impl_->maker = std::move(maker); }

void ReportingComponent::withReport(const std::function<void(Report*)>& use) {
    const std::lock_guard<std::mutex> rows(impl_->rows);
    use(impl_->report.get());
}

std::unique_ptr<Report> ReportingComponent::Impl::makeReport(const reporting::Sources& present) {
    const reporting::ReportOptions all = options();  // asks the sink, so before it is moved
    if (maker) return maker(present, all);
    return std::unique_ptr<Report>(new RunningReport(present, all, std::move(sink), marshallers));
}

bool ReportingComponent::configureHook() {
    const std::lock_guard<std::mutex> lock(impl_->changes);
    return impl_->addEntries();
}

bool ReportingComponent::Impl::isPeriodic() const { return self.getActivity() && self.getActivity()->isPeriodic(); }

reporting::ReportOptions ReportingComponent::Impl::options() const {
    reporting::ReportOptions result;
    const bool apart = decompose || (sink && sink->hasStructure());
    result.decomposition = !apart                          ? Decomposition::None
                           : complexDecompose && decompose ? Decomposition::Types
                                                           : Decomposition::Members;
    result.rows.component = self.getName();
    result.rows.header = writeHeader;
    result.rows.repeatHeader = repeatHeader;
    result.rows.onlyNewData = onlyNewData;
    result.rows.decompose = decompose;
    result.onFailure = [this] { (void)self.trigger(); };  // updateHook() checks for the failure
    result.rows.digits = std::max(1, std::min(precision, std::numeric_limits<double>::max_digits10));
    result.begin =
        synchronize ? RTT::Logger::Instance()->getReferenceTime() : RTT::os::TimeService::Instance()->getTicks();
    return result;
}

bool ReportingComponent::startHook() {
    const std::lock_guard<std::mutex> changes(impl_->changes);
    const std::lock_guard<std::mutex> rows(impl_->rows);
    if (!impl_->maker && !impl_->sink && impl_->marshallers.empty()) {
        log(RTT::Error) << "'" << getName() << "' needs at least one marshaller to write reports" << endlog();
        return false;
    }
    const reporting::Sources sources = impl_->present();
    impl_->lostRows = 0;
    impl_->report = impl_->makeReport(sources);
    if (!impl_->report) return false;
    const bool periodic = impl_->isPeriodic();
    if (periodic) impl_->report->writeRow();
    impl_->report->clearPorts();
    impl_->report->wakeOnData(!impl_->snapshotOnly && !periodic);
    return true;
}

/** Writes rows for new samples; false if there may be more. */
bool ReportingComponent::Impl::writeNewRows(Report& from) {
    for (int rows = 0; rows < kRowsPerCycle; ++rows) {
        if (!from.read()) return true;
        from.writeRow();
    }
    return false;
}

void ReportingComponent::updateHook() {
    Report& report = *impl_->report;
    if (impl_->isPeriodic()) {
        (void)report.read();
        report.writeRow();
    } else if (!impl_->snapshotOnly) {
        if (!impl_->writeNewRows(report)) (void)trigger();
    }
    impl_->lostRows = static_cast<unsigned int>(report.lost());
    // The user must make room and then start the report anew.
    if (report.failed()) error();
}

void ReportingComponent::snapshot() {
    // Nobody else locks it while the component runs, but stopHook() may run in another thread.
    const std::unique_lock<std::mutex> rows(impl_->rows, std::try_to_lock);
    if (!rows || !impl_->report || impl_->isPeriodic()) return;
    (void)impl_->report->read();
    impl_->report->writeRow();
    impl_->lostRows = static_cast<unsigned int>(impl_->report->lost());
}

void ReportingComponent::stopHook() {
    const std::lock_guard<std::mutex> rows(impl_->rows);
    if (!impl_->report) return;
    impl_->report->wakeOnData(false);
    // Samples from before stop() belong to the report, even if this thread had no time for them.
    if (!impl_->snapshotOnly && !impl_->isPeriodic()) (void)impl_->writeNewRows(*impl_->report);
    impl_->report->finish();
    impl_->lostRows = static_cast<unsigned int>(impl_->report->lost());
    impl_->report.reset();
}

void ReportingComponent::cleanupHook() {
    const std::lock_guard<std::mutex> lock(impl_->changes);
    impl_->forgetAll();
}

// --- operations ----------------------------------------------------------------------------------------------------

bool ReportingComponent::reportComponent(const std::string& component) {
    const std::lock_guard<std::mutex> lock(impl_->changes);
    if (!impl_->addComponent(component, Impl::Known::ConnectAnew)) return false;
    impl_->rememberEntry("Component", component);
    return true;
}

bool ReportingComponent::unreportComponent(const std::string& component) {
    const std::lock_guard<std::mutex> lock(impl_->changes);
    return impl_->removeAllOf(component);
}

bool ReportingComponent::reportData(const std::string& component, const std::string& data) {
    const std::lock_guard<std::mutex> lock(impl_->changes);
    if (!impl_->addData(component, data)) return false;
    if (impl_->isReported(component + "." + data)) impl_->rememberEntry("Data", component + "." + data);
    return true;
}

bool ReportingComponent::unreportData(const std::string& component, const std::string& data) {
    const std::lock_guard<std::mutex> lock(impl_->changes);
    (void)impl_->forgetEntry("Data", component + "." + data);
    return impl_->remove(component + "." + data);
}

bool ReportingComponent::reportPort(const std::string& component, const std::string& port) {
    const std::lock_guard<std::mutex> lock(impl_->changes);
    if (!impl_->addPort(component, port)) return false;
    impl_->rememberEntry("Port", component + "." + port);
    return true;
}

bool ReportingComponent::unreportPort(const std::string& component, const std::string& port) {
    const std::lock_guard<std::mutex> lock(impl_->changes);
    (void)impl_->forgetEntry("Port", component + "." + port);
    return impl_->remove(component + "." + port);
}

}  // namespace OCL
