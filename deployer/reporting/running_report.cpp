// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "running_report.hpp"

#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>

#include <algorithm>
#include <string_view>
#include <utility>

namespace OCL::reporting {
namespace {

const char* const kTimeStamp = "TimeStamp";

/** How many rows the writer may be behind: two seconds at 1 kHz. */
constexpr std::size_t kRowsBehind = 2000;
constexpr std::size_t kLeastRoom = std::size_t(1) << 20;
constexpr std::size_t kMostRoom = std::size_t(1) << 26;
/** The fewest rows, even if they are long: a sequence may hold an image. */
constexpr std::size_t kFewestRows = 4;

void write(RTT::marsh::MarshallInterface* marshaller, const RTT::PropertyBag& bag) {
    if (!marshaller) return;
    marshaller->serialize(bag);
    marshaller->flush();
}

std::size_t roomFor(std::size_t row) {
    return std::max(std::clamp(row * kRowsBehind, kLeastRoom, kMostRoom), row * kFewestRows);
}

}  // namespace

RunningReport::RunningReport(const Sources& sources, const ReportOptions& options, std::unique_ptr<TextTarget> target,
                             const std::vector<Marshallers>& marshallers)
    : options_(options), marshallers_(marshallers), record_(target && target->wantsNames()) {
    entries_.reserve(sources.size());
    for (const std::shared_ptr<Source>& source : sources) {
        source->prepare();  // the columns depend on the size of sequences
        entries_.emplace_back(source, ValueTree(source->name(), source->sample(), options.decomposition, others_));
    }
    if (target) {
        encodeRow(0.0);
        record_.expect(2 * record_.size());
        target->begin(names());
        writer_.reset(new RowWriter(options.component + ".Writer", std::move(target), roomFor(record_.size()),
                                    options.digits, options.onFailure));
    }
    if (options.header) writeHeader();
}

std::vector<std::string> RunningReport::names() const {
    std::vector<std::string> result{kTimeStamp};
    for (const Entry& entry : entries_) result.push_back(entry.source->name());
    return result;
}

bool RunningReport::read() {
    bool any = false;
    for (Entry& entry : entries_) {
        const bool isNew = entry.source->read();
        entry.changed |= isNew;
        any |= isNew;
    }
    return any;
}

void RunningReport::chooseEntries() {
    otherColumns_ = false;
    if (!options_.onlyNewData) return;
    for (Entry& entry : entries_) {
        entry.wanted = hasChanged(entry);
        entry.changed = false;
    }
}

/** True for a port with a new sample and for a value that differs from the last row; always true before the first
    row. */
bool RunningReport::hasChanged(Entry& entry) {
    if (entry.source->port()) return entry.changed;
    part_.clear();
    otherColumns_ |= entry.tree.encode(part_);
    if (!entry.changed && std::string_view(part_.data(), part_.size()) == entry.last) return false;
    entry.last.assign(part_.data(), part_.size());
    return true;
}

void RunningReport::encodeRow(double time) {
    record_.clear();
    if (record_.named()) record_.text(Tag::Name, kTimeStamp);
    record_.value(Tag::Real, time);
    for (Entry& entry : entries_)
        if (entry.wanted) otherColumns_ |= entry.tree.encode(record_);
}

void RunningReport::writeRow() {
    const double time = RTT::os::TimeService::Instance()->secondsSince(options_.begin);
    chooseEntries();
    if (!marshallers_.empty()) {
        RTT::PropertyBag bag("Report");
        fill(bag, time);
        for (const Marshallers& marshaller : marshallers_) write(marshaller.body.get(), bag);
    }
    if (!writer_) return;
    encodeRow(time);
    if (otherColumns_ && !record_.named()) columnsChanged();
    push(record_);
}

void RunningReport::columnsChanged() {
    if (!std::exchange(everChanged_, true))
        RTT::log(RTT::Warning) << "the columns of the report of '" << options_.component
                               << "' have changed, because a sequence has another size now"
                               << (options_.repeatHeader || !options_.header
                                       ? ""
                                       : "; the header fits the rows before (see property RepeatHeader)")
                               << RTT::endlog();
    if (options_.header && options_.repeatHeader) writeHeader();
}

void RunningReport::writeHeader() {
    if (!marshallers_.empty()) {
        RTT::PropertyBag bag("Report");
        fill(bag, 0.0);
        for (const Marshallers& marshaller : marshallers_) write(marshaller.header.get(), bag);
    }
    if (!writer_) return;
    std::string line = std::string(" ") + kTimeStamp;
    for (const Entry& entry : entries_) entry.tree.appendNames(line);
    Record header;
    header.text(Tag::Line, line);
    push(header);
}

void RunningReport::fill(RTT::PropertyBag& bag, double time) {
    bag.ownProperty(new RTT::Property<double>(kTimeStamp, "The time at which the data was read.", time));
    for (Entry& entry : entries_)
        if (entry.wanted) entry.tree.addTo(bag);
}

void RunningReport::push(const Record& record) {
    // Not at each growth of a row: until it has twice its size, half of the room is enough.
    const std::size_t room = roomFor(record.size());
    if (writer_->room() < room / 2) writer_->makeRoom(room);
    if (writer_->push(record) || std::exchange(everLost_, true)) return;
    RTT::log(RTT::Error) << "a row of the report of '" << options_.component
                         << "' is lost: its target does not take them as fast as they come" << RTT::endlog();
}

void RunningReport::clearPorts() {
    for (Entry& entry : entries_) {
        entry.source->clear();
        if (entry.source->port()) entry.changed = false;
    }
}

void RunningReport::wakeOnData(bool on) {
    for (Entry& entry : entries_)
        if (RTT::base::InputPortInterface* const port = entry.source->port()) port->signalInterface(on);
}

void RunningReport::finish() {
    if (!writer_) return;
    writer_->finish();
    if (writer_->lost() != 0)
        RTT::log(RTT::Error) << writer_->lost() << " rows of the report of '" << options_.component << "' are lost"
                             << RTT::endlog();
}

}  // namespace OCL::reporting
