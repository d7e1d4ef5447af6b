// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_sink.hpp"

#include "netcdf_row.hpp"
#include "netcdf_writer.hpp"

#include <rtt/Logger.hpp>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <utility>

namespace OCL::reporting {
namespace {

/** How often the sink looks whether the file is still there. */
constexpr std::chrono::seconds kLook(1);

std::string now() {
    const std::time_t seconds = std::time(nullptr);
    std::tm parts{};
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&seconds, &parts))};
}

class NetcdfSink : public RowSink {
public:
    NetcdfSink(std::unique_ptr<NetcdfFile> file, std::uint64_t rewrittenUpTo)
        : file_(std::move(file)), first_(file_->path()), rewrittenUpTo_(rewrittenUpTo) {}

    void prepare(const RowOptions& options) override {
        options_ = options;
        columns_.reset(new Columns({true, !options.decompose}));
        row_.reset(new NetcdfRow(*columns_, layout_));
    }
    bool hasStructure() const override { return true; }

    void fields(const Field& report, const char* record, std::size_t size) override {
        columns_->adopt(report);
        take(record, size);
        if (error_.empty()) layout_.takeBackRow();
    }
    void row(const char* record, std::size_t size) override {
        take(record, size);
        ++rows_;
        if (waiting() >= kNetcdfBlock) flush();
    }
    std::size_t waiting() const override { return rows_ * file_->rowSize(); }
    std::string write() override {
        flush();
        return error_;
    }
    unsigned long rows() const override { return rows_; }
    std::string name() const override { return "file '" + file_->path() + "'"; }

private:
    /** Adds a row to those that wait; first makes room if it needs some. */
    void take(const char* record, std::size_t size) {
        if (!error_.empty()) return;
        put(record, size);
        if (!row_->isCut() && columns_->all().size() == layout_.variables().size()) return;
        layout_.takeBackRow();
        flush();
        if (error_.empty()) error_ = makeRoom();
        if (error_.empty()) put(record, size);
    }
    void put(const char* record, std::size_t size) {
        row_->begin();
        columns_->walk(RecordReader(record, size), *row_);
    }

    /** Writes the rows that wait. After an error, they and those that follow are lost. */
    void flush() {
        if (error_.empty()) error_ = look();
        if (error_.empty() && rows_ != 0) error_ = file_->append(layout_.variables(), rows_);
        layout_.clearRows();
        if (error_.empty()) rows_ = 0;
    }
    std::string look() {
        const auto time = std::chrono::steady_clock::now();
        if (time - looked_ < kLook) return {};
        looked_ = time;
        return file_->lost();
    }

    std::string makeRoom() {
        layout_.grow(columns_->all(), row_->wanted(), options_.onlyNewData);
        tellNames();
        if (file_->rows() == 0) return begin(*file_);
        return file_->size() > rewrittenUpTo_ ? goOn() : rewrite();
    }
    std::string begin(NetcdfFile& file) {
        std::vector<NetcdfText> attributes = {{"Conventions", "CF-1.8"},
                                              {"title", "Report of " + options_.component},
                                              {"date_created", created_},
                                              continuedIn({})};
        if (!continues_.empty()) attributes.push_back({"continues", continues_});
        return file.begin(layout_.variables(), attributes);
    }
    /** With room for a name that is known later. */
    NetcdfText continuedIn(std::string name) const {
        name.resize(nameOf(~0U).filename().string().size());
        return {"continued_in", std::move(name)};
    }
    std::filesystem::path nameOf(unsigned number) const {
        const std::filesystem::path first(first_);
        return first.parent_path() /
               (first.stem().string() + '.' + std::to_string(number) + first.extension().string());
    }

    /** Copies the file into one with the present layout, which then takes its place: the library would move rows
        within the file, which would be unreadable if the process ended meanwhile. */
    std::string rewrite() {
        std::string error;
        const std::string name = file_->path() + ".new";
        std::unique_ptr<NetcdfFile> next = NetcdfFile::open(name, error);
        if (!next) return "could not make '" + name + "', which gives its variables more room: " + error;
        error = begin(*next);
        if (error.empty()) error = next->copy(*file_);
        if (error.empty()) error = next->replace(*file_);
        if (error.empty())
            file_ = std::move(next);
        else
            (void)std::remove(name.c_str());
        return error;
    }

    /** Goes on in another file. */
    std::string goOn() {
        const std::filesystem::path name = nameOf(++number_);
        std::string error;
        std::unique_ptr<NetcdfFile> next = NetcdfFile::open(name.string(), error);
        if (!next) return "it goes on in '" + name.string() + "', which could not be opened: " + error;
        error = file_->change(continuedIn(name.filename().string()));
        continues_ = std::filesystem::path(file_->path()).filename().string();
        if (error.empty()) error = begin(*next);
        file_ = std::move(next);
        RTT::log(RTT::Warning) << "the report of '" << options_.component << "' goes on in file '" << name.string()
                               << "', because a sequence, text or bag has grown" << RTT::endlog();
        return error;
    }

    void tellNames() {
        const std::size_t count = layout_.renamed().size();
        if (count == std::exchange(told_, count)) return;
        const std::size_t column = layout_.renamed().back();
        RTT::log(RTT::Warning) << count << " variables of the report of '" << options_.component
                               << "' have other names than what they report, because NetCDF does not allow those or "
                                  "has them already: '"
                               << columns_->all()[column].name << "' is '" << layout_.variables()[column].name
                               << "'; the attribute reported_as has the name" << RTT::endlog();
    }

    std::unique_ptr<NetcdfFile> file_;
    const std::string first_;
    const std::uint64_t rewrittenUpTo_;
    const std::string created_ = now();
    RowOptions options_;
    std::unique_ptr<Columns> columns_;
    NetcdfLayout layout_;
    std::unique_ptr<NetcdfRow> row_;
    std::size_t rows_ = 0;  // that wait
    std::string error_;
    std::string continues_;  // the file before
    unsigned number_ = 1;
    std::size_t told_ = 0;  // names
    std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

}  // namespace

std::unique_ptr<RowSink> netcdfSink(std::unique_ptr<NetcdfFile> file, std::uint64_t rewrittenUpTo) {
    return std::unique_ptr<RowSink>(new NetcdfSink(std::move(file), rewrittenUpTo));
}

}  // namespace OCL::reporting

OCL::reporting::RowSink* oclNetcdfSink(const std::string& file, std::string& error) {
    auto opened = OCL::reporting::NetcdfFile::open(file, error);
    return opened ? OCL::reporting::netcdfSink(std::move(opened)).release() : nullptr;
}
