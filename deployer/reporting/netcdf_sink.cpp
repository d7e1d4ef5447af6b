// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_sink.hpp"

#include "netcdf_row.hpp"

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
constexpr std::size_t kCopied = std::size_t(1) << 20;  // bytes at a time
const char* const kContinuedIn = "continued_in";

std::string now() {
    const std::time_t seconds = std::time(nullptr);
    std::tm parts{};
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&seconds, &parts))};
}

/** The place of the value of an attribute of the file. */
std::size_t placeOfText(const std::string& header, const std::string& name) {
    std::string begin;
    appendBig(begin, ClassicType::UInt64, name.size());
    begin += name;
    begin.append((4 - name.size() % 4) % 4, '\0');
    appendBig(begin, ClassicType::UInt, static_cast<std::uint32_t>(ClassicType::Char));
    return header.find(begin) + begin.size() + sizeof(std::uint64_t);
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
        records_.resize(records_.size() - layout_.recordSize());
    }
    void row(const char* record, std::size_t size) override {
        take(record, size);
        ++rows_;
    }
    std::size_t waiting() const override { return records_.size(); }
    std::string write() override {
        if (error_.empty()) error_ = flush();
        return error_;
    }
    unsigned long rows() const override { return rows_; }
    std::string name() const override { return "file '" + file_->path() + "'"; }

private:
    /** Appends a record to those that wait; first makes room if it needs some. */
    void take(const char* record, std::size_t size) {
        put(record, size);
        const bool fits = !row_->isCut() && columns_->all().size() == layout_.places().size();
        if (fits || !error_.empty()) return;
        records_.resize(records_.size() - layout_.recordSize());
        error_ = makeRoom();
        put(record, size);
    }
    void put(const char* record, std::size_t size) {
        row_->begin(records_);
        columns_->walk(RecordReader(record, size), *row_);
    }

    std::string flush() {
        std::string error = look();
        std::size_t written = 0;
        if (error.empty() && !records_.empty()) error = file_->append(records_, written);
        rows_ -= std::min<unsigned long>(rows_, written);
        records_.clear();
        return error;
    }
    std::string look() {
        const auto time = std::chrono::steady_clock::now();
        if (time - looked_ < kLook) return {};
        looked_ = time;
        return file_->lost();
    }

    std::string makeRoom() {
        if (std::string error = flush(); !error.empty()) return error;
        const std::vector<NetcdfLayout::Place> earlier = layout_.places();
        const std::size_t earlierSize = layout_.recordSize();
        layout_.grow(columns_->all(), row_->wanted(), options_.onlyNewData);
        tellNames();
        if (file_->records() == 0) return begin(*file_, {});
        return file_->size() > rewrittenUpTo_ ? goOn() : rewrite(earlier, earlierSize);
    }
    std::string begin(NetcdfFile& file, const std::string& continues) {
        std::vector<ClassicAttribute> attributes = {
            ClassicAttribute::text("Conventions", "CF-1.8"),
            ClassicAttribute::text("title", "Report of " + options_.component),
            ClassicAttribute::text("date_created", created_),
            // Room for a name that is known later.
            ClassicAttribute::text(kContinuedIn, std::string(nameOf(~0U).filename().string().size(), '\0')),
        };
        if (!continues.empty()) attributes.push_back(ClassicAttribute::text("continues", continues));
        const std::string header = classicHeader(layout_.variables(), attributes);
        continuedIn_ = placeOfText(header, kContinuedIn);
        return file.begin(header, layout_.recordSize());
    }
    std::filesystem::path nameOf(unsigned number) const {
        const std::filesystem::path first(first_);
        return first.parent_path() /
               (first.stem().string() + '.' + std::to_string(number) + first.extension().string());
    }

    /** Copies the file into one with the present layout, which then takes its place. */
    std::string rewrite(const std::vector<NetcdfLayout::Place>& earlier, std::size_t earlierSize) {
        std::string error;
        const std::string name = file_->path() + ".new";
        std::unique_ptr<NetcdfFile> next = NetcdfFile::open(name, error);
        if (!next) return "could not make '" + name + "', which gives its variables more room: " + error;
        error = begin(*next, continues_);
        const std::size_t some = std::max<std::size_t>(1, kCopied / earlierSize);
        std::string from, to;
        for (std::uint64_t at = 0; error.empty() && at < file_->records(); at += some) {
            error = file_->read(at, some, from);
            to.clear();
            for (std::size_t place = 0; error.empty() && place != from.size(); place += earlierSize)
                layout_.appendConverted(to, from.data() + place, earlier);
            std::size_t written = 0;
            if (error.empty()) error = next->append(to, written);
        }
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
        const std::string before = std::filesystem::path(file_->path()).filename().string();
        error = file_->change(continuedIn_, name.filename().string());
        continues_ = before;
        if (error.empty()) error = begin(*next, before);
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
    std::string records_;     // those that wait
    unsigned long rows_ = 0;  // how many of them are rows
    std::string error_;
    std::string continues_;  // the file before
    std::size_t continuedIn_ = 0;
    unsigned number_ = 1;
    std::size_t told_ = 0;  // names
    std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

}  // namespace

std::unique_ptr<RowSink> netcdfSink(std::unique_ptr<NetcdfFile> file, std::uint64_t rewrittenUpTo) {
    return std::unique_ptr<RowSink>(new NetcdfSink(std::move(file), rewrittenUpTo));
}

}  // namespace OCL::reporting
