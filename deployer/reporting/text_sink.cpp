// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "text_sink.hpp"

#include "columns.hpp"

#include <rtt/Logger.hpp>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace OCL::reporting {
namespace {

typedef std::vector<char> Text;

void append(Text& text, std::string_view more) { text.insert(text.end(), more.begin(), more.end()); }

/** Makes the fields of a row. */
class Fields : public ValueTaker {
public:
    struct Span {
        std::size_t begin = 0, end = 0;
        std::size_t blanks = 0;  // 0: there is no value
    };

    explicit Fields(TextFormat format) : format_(format) {}
    void useDigits(int digits) { digits_ = digits; }

    void clear(std::size_t columns) {
        text_.clear();
        spans_.assign(columns, Span());
        blanks_ = 1;
        next_ = 0;
        inOrder_ = true;
    }
    const std::vector<Span>& spans() const { return spans_; }
    std::string_view text(const Span& span) const { return {text_.data() + span.begin, span.end - span.begin}; }
    /** True if each column has a value, and the values came in the order of the columns. */
    bool complete() const { return inOrder_ && next_ == spans_.size(); }

    void bag() override { ++blanks_; }
    void value(std::size_t column, Tag tag, RecordReader& record) override {
        const std::size_t begin = text_.size();
        appendValue(text_, tag, record, format_, digits_);
        put(column, begin);
    }
    void count(std::size_t column, std::uint32_t) override {
        const std::size_t begin = text_.size();
        text_.push_back('0');
        put(column, begin);
    }

private:
    void put(std::size_t column, std::size_t begin) {
        if (column >= spans_.size()) spans_.resize(column + 1);
        spans_[column] = {begin, text_.size(), std::exchange(blanks_, 1)};
        inOrder_ &= column == next_++;
    }

    const TextFormat format_;
    int digits_ = 6;
    Text text_;
    std::vector<Span> spans_;
    std::size_t blanks_ = 1;  // before the next value
    std::size_t next_ = 0;
    bool inOrder_ = true;
};

class TextSink : public RowSink {
public:
    TextSink(std::unique_ptr<TextTarget> target, TextFormat format)
        : target_(std::move(target)), format_(format), columns_({}), fields_(format) {}

    void prepare(const RowOptions& options) override {
        options_ = options;
        fields_.useDigits(options.digits);
    }
    void fields(const Field& report, const char* record, std::size_t size) override {
        columns_.adopt(report);
        columns_.walk(RecordReader(record, size), begin());
        showNewColumns();
    }
    void row(const char* record, std::size_t size) override {
        columns_.walk(RecordReader(record, size), begin());
        showNewColumns();
        if (format_ == TextFormat::Csv)
            appendSeparated();
        else
            appendBlanked();
        text_.push_back('\n');
        ++rows_;
    }
    std::size_t waiting() const override { return text_.size(); }
    std::string write() override {
        std::string error;
        if (!text_.empty()) error = target_->write(text_.data(), text_.size());
        if (!error.empty()) return error;
        rows_ = 0;
        text_.clear();
        return error;
    }
    unsigned long rows() const override { return rows_; }
    std::string name() const override { return target_->name(); }

private:
    ValueTaker& begin() {
        fields_.clear(columns_.all().size());
        return fields_;
    }
    void showNewColumns() {
        const std::size_t count = columns_.all().size();
        const std::size_t before = std::exchange(shown_, count);
        if (before == count) return;
        if (options_.header && (before == 0 || options_.repeatHeader)) appendHeader();
        if (before == 0 || std::exchange(told_, true)) return;
        RTT::log(RTT::Warning) << "the report of '" << options_.component << "' has more columns since '"
                               << columns_.all()[before].name << "', because a sequence or bag has grown; they come"
                               << " after all others"
                               << (options_.header && options_.repeatHeader ? ", below a new header"
                                   : options_.header ? "; the header does not have them (see property RepeatHeader)"
                                                     : "")
                               << RTT::endlog();
    }
    void appendHeader() {
        for (std::size_t i = 0; i != columns_.all().size(); ++i) {
            if (format_ == TextFormat::Columns || i != 0) text_.push_back(separator());
            appendField(text_, columns_.all()[i].name, format_);
        }
        text_.push_back('\n');
    }
    void appendSeparated() {
        const std::vector<Fields::Span>& spans = fields_.spans();
        for (std::size_t i = 0; i != spans.size(); ++i) {
            if (i != 0) text_.push_back(separator());
            append(text_, fields_.text(spans[i]));
        }
    }
    void appendBlanked() {
        const bool complete = fields_.complete();
        for (const Fields::Span& span : fields_.spans()) {
            text_.insert(text_.end(), complete ? span.blanks : 1, ' ');
            append(text_, span.blanks != 0 ? fields_.text(span) : "nan");
        }
        text_.push_back(' ');
    }
    char separator() const { return format_ == TextFormat::Csv ? ',' : ' '; }

    const std::unique_ptr<TextTarget> target_;
    const TextFormat format_;
    RowOptions options_;
    Columns columns_;
    Fields fields_;
    Text text_;
    unsigned long rows_ = 0;  // rows in text_
    std::size_t shown_ = 0;   // columns that a header was written for
    bool told_ = false;
};

}  // namespace

std::unique_ptr<RowSink> textSink(std::unique_ptr<TextTarget> target, TextFormat format) {
    return std::unique_ptr<RowSink>(new TextSink(std::move(target), format));
}

std::optional<TextFormat> textFormat(const std::string& name, const std::string& component) {
    if (name == "columns") return TextFormat::Columns;
    if (name == "csv") return TextFormat::Csv;
    RTT::log(RTT::Error) << "the property Format of '" << component << "' is '" << name
                         << "'; it must be 'columns' or 'csv'" << RTT::endlog();
    return std::nullopt;
}

}  // namespace OCL::reporting
