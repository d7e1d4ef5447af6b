// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <reporting/record.hpp>
#include <reporting/row_writer.hpp>
#include <reporting/text_sink.hpp>
#include <support/temp_dir.hpp>

#include <rtt/Logger.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <fcntl.h>
#include <iostream>
#include <memory>
#include <mutex>
#include <new>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace OCL::reporting;

constexpr std::size_t kRoom = 1 << 16;

Record row(std::int64_t number) {
    Record record;
    record.value(Tag::Signed, number);
    return record;
}

/** A writer of rows of one number. */
class Writer {
public:
    explicit Writer(std::unique_ptr<TextTarget> target) : writer_("writer", rowsOf(std::move(target)), kRoom) {
        Field report;
        report.kind = Field::Kind::Group;
        report.parts.emplace_back();
        EXPECT_TRUE(writer_.pushFields(report, row(0)));
    }
    bool push(const Record& record) { return writer_.push(record); }
    void finish() { writer_.finish(); }
    unsigned long lost() const { return writer_.lost(); }

private:
    static std::unique_ptr<RowSink> rowsOf(std::unique_ptr<TextTarget> target) {
        auto sink = textSink(std::move(target), TextFormat::Columns);
        RowOptions options;
        options.header = false;
        sink->prepare(options);
        return sink;
    }

    RowWriter writer_;
};

/** Keeps its writer waiting until it is opened; may fail then. */
class Gate : public TextTarget {
public:
    Gate(std::string& text, bool good) : text_(text), good_(good) {}

    std::string write(const char* text, std::size_t size) override {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return open_; });
        if (!good_) return "the disk is full";
        text_.append(text, size);
        return {};
    }
    std::string name() const override { return "the gate"; }
    bool hasSeen(const std::string& text) {
        const std::lock_guard<std::mutex> lock(mutex_);
        return text_.find(text) != std::string::npos;
    }
    void open() {
        const std::lock_guard<std::mutex> lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }

private:
    std::string& text_;
    const bool good_;
    bool open_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
};

TEST(RowWriter, WritesEverythingBeforeItEnds) {
    for (int round = 0; round < 50; ++round) {
        std::ostringstream text, expected;
        Writer writer(useStream(text));
        for (int i = 0; i < round * 7; ++i) {
            ASSERT_TRUE(writer.push(row(i)));
            expected << ' ' << i << " \n";
        }
        writer.finish();
        ASSERT_EQ(expected.str(), text.str());
        ASSERT_EQ(0u, writer.lost());
    }
}

TEST(RowWriter, RowsComeOutByThemselves) {
    std::string text;
    auto* const gate = new Gate(text, true);
    Writer writer{std::unique_ptr<TextTarget>(gate)};
    gate->open();
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(writer.push(row(i)));
        // Sometimes it is asleep again, sometimes it gathers.
        std::this_thread::sleep_for(std::chrono::milliseconds(i));
    }
    for (int i = 0; i < 1000 && !gate->hasSeen(" 19 \n"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(gate->hasSeen(" 19 \n"));
    writer.finish();
}

TEST(RowWriter, RowsThatFindNoRoomAreCounted) {
    std::string text;
    auto* const gate = new Gate(text, true);
    Writer writer{std::unique_ptr<TextTarget>(gate)};
    const Record record = row(1);
    unsigned long refused = 0, taken = 0;
    while (refused < 100) ++(writer.push(record) ? taken : refused);
    EXPECT_EQ(100u, writer.lost());
    gate->open();
    writer.finish();
    EXPECT_EQ(100u, writer.lost());
    EXPECT_EQ(taken * 4, text.size());  // " 1 \n"
}

TEST(RowWriter, SaysWhatItWaitsForAtTheEnd) {
    std::ostringstream log;
    RTT::Logger::Instance()->setStdStream(log);
    std::string text;
    auto* const gate = new Gate(text, true);
    Writer writer{std::unique_ptr<TextTarget>(gate)};
    ASSERT_TRUE(writer.push(row(1)));
    std::thread opener([gate] {
        std::this_thread::sleep_for(std::chrono::milliseconds(2300));
        gate->open();
    });
    writer.finish();
    opener.join();
    RTT::Logger::Instance()->setStdStream(std::cerr);
    EXPECT_EQ(" 1 \n", text);
    const std::string said = log.str();
    const std::size_t first = said.find("waiting for the gate to take the last rows of a report");
    EXPECT_NE(std::string::npos, first) << said;
    EXPECT_EQ(std::string::npos, said.find("waiting for", first + 1)) << said;
}

TEST(RowWriter, NothingFollowsALineThatCouldNotBeWritten) {
    std::string text;
    auto* const gate = new Gate(text, false);
    Writer writer{std::unique_ptr<TextTarget>(gate)};
    gate->open();
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(writer.push(row(i)));
    writer.finish();
    EXPECT_EQ(10u, writer.lost());
    EXPECT_EQ("", text);
}

/** Keeps rows, and throws at one of its functions. */
class Faulty : public RowSink {
public:
    enum At { Fields, Row, Write };
    explicit Faulty(At at) : at_(at) {}

    void fields(const Field&, const char*, std::size_t) override { reach(Fields); }
    void row(const char*, std::size_t) override {
        if (rows_ == 3) reach(Row);
        ++rows_;
    }
    std::size_t waiting() const override { return 0; }
    std::string write() override {
        if (rows_ >= 3) reach(Write);
        return {};
    }
    unsigned long rows() const override { return rows_; }
    std::string name() const override { return "the faulty sink"; }

private:
    void reach(At at) const {
        if (at == at_) throw std::bad_alloc();
    }
    const At at_;
    unsigned long rows_ = 0;
};

TEST(RowWriter, AllRowsThatWaitAreLostWhenASinkThrows) {
    for (const Faulty::At at : {Faulty::Fields, Faulty::Row, Faulty::Write}) {
        int failures = 0;
        RowWriter writer("writer", std::make_unique<Faulty>(at), kRoom, [&failures] { ++failures; });
        for (int i = 0; i < 5; ++i) ASSERT_TRUE(writer.push(row(i)));
        ASSERT_TRUE(writer.pushFields(Field(), row(0)));  // which is freed in any case
        for (int i = 0; i < 5; ++i) ASSERT_TRUE(writer.push(row(i)));
        writer.finish();
        EXPECT_TRUE(writer.failed());
        EXPECT_EQ(1, failures);
        EXPECT_EQ(10u, writer.lost()) << at;
    }
}

/** Needs a millisecond for a row, and has not so much patience at the end. */
class Hasty : public RowSink {
public:
    explicit Hasty(unsigned long& taken) : taken_(taken) {}

    void fields(const Field&, const char*, std::size_t) override {}
    void row(const char*, std::size_t) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ++taken_;
    }
    std::size_t waiting() const override { return 0; }
    std::string write() override { return {}; }
    unsigned long rows() const override { return 0; }
    std::chrono::milliseconds patience() const override { return std::chrono::milliseconds(50); }
    std::string name() const override { return "the hasty sink"; }

private:
    unsigned long& taken_;
};

TEST(RowWriter, RowsThatASinkHasNoPatienceForAreLost) {
    unsigned long taken = 0;
    RowWriter writer("writer", std::make_unique<Hasty>(taken), kRoom);
    for (int i = 0; i < 3000; ++i) ASSERT_TRUE(writer.push(row(i)));
    writer.finish();
    EXPECT_FALSE(writer.failed());
    EXPECT_EQ(3000u, taken + writer.lost());
    EXPECT_GT(writer.lost(), 0u);
    EXPECT_GT(taken, 0u);
}

TEST(RowWriter, FileThatCannotBeOpenedSaysWhy) {
    std::string error;
    EXPECT_EQ(nullptr, openFile("/no/such/folder/reports.dat", error));
    EXPECT_EQ("No such file or directory", error);
}

/** A file of the test. */
class ReportFile : public testing::Test {
protected:
    static void put(TextTarget& target, const std::string& text) {
        EXPECT_EQ("", target.write(text.data(), text.size()));
    }
    const oroforge::test::TempDir directory_;
    const std::string name_ = (directory_.path() / "reports.dat").string();
    std::string error_;
};

TEST_F(ReportFile, BeginsAnewEachTime) {
    for (const char* text : {"a long text\n", "short\n"}) {
        const std::unique_ptr<TextTarget> file = openFile(name_, error_);
        ASSERT_NE(nullptr, file) << error_;
        put(*file, text);
    }
    EXPECT_EQ("short\n", oroforge::test::readFile(name_));
}

TEST_F(ReportFile, BelongsToOneReporterAtATime) {
    std::unique_ptr<TextTarget> first = openFile(name_, error_);
    ASSERT_NE(nullptr, first);
    put(*first, "a row\n");
    EXPECT_EQ(nullptr, openFile(name_, error_));
    EXPECT_EQ("another reporter is writing to it", error_);
    EXPECT_EQ("a row\n", oroforge::test::readFile(name_));
    first.reset();
    error_.clear();
    EXPECT_NE(nullptr, openFile(name_, error_));
    EXPECT_EQ("", error_);
}

TEST_F(ReportFile, EndsAtAWholeRowEvenIfRowsHaveLineEnds) {
    const std::unique_ptr<TextTarget> file = openFile(name_, error_);
    ASSERT_NE(nullptr, file) << error_;
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{14, before.rlim_max};  // ends behind the first line of the second row
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string text = "1,\"a\nb\"\n2,\"c\nd\"\n";
    EXPECT_EQ("File too large", file->write(text.data(), text.size()));
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ("1,\"a\nb\"\n", oroforge::test::readFile(name_));
}

TEST_F(ReportFile, OfADeviceBelongsToAll) {
    const std::unique_ptr<TextTarget> one = openFile("/dev/null", error_), other = openFile("/dev/null", error_);
    EXPECT_TRUE(one && other) << error_;
}

/** Which of these signals its writer does not take. */
class Signals : public TextTarget {
public:
    explicit Signals(std::string& text) : text_(text) {}

    std::string write(const char*, std::size_t) override {
        sigset_t blocked;
        pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
        if (sigismember(&blocked, SIGPIPE) == 1) text_ += "SIGPIPE ";
        if (sigismember(&blocked, SIGXFSZ) == 1) text_ += "SIGXFSZ ";
        if (sigismember(&blocked, SIGTERM) == 1) text_ += "SIGTERM ";
        return {};
    }
    std::string name() const override { return "the signals"; }

private:
    std::string& text_;
};

TEST(RowWriter, WritingToWhatTakesNoMoreIsAnErrorAndNoSignal) {
    std::string text;
    Writer writer(std::make_unique<Signals>(text));
    ASSERT_TRUE(writer.push(row(1)));
    writer.finish();
    EXPECT_EQ("SIGPIPE SIGXFSZ ", text);
}

TEST(RowWriter, APipeWithoutReaderIsAnErrorInTheLog) {
    const oroforge::test::TempDir folder;
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(0, mkfifo(pipe.c_str(), 0600));
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_LE(0, reader);
    std::string error;
    std::unique_ptr<TextTarget> target = openFile(pipe, error);
    close(reader);
    ASSERT_EQ("", error);
    std::ostringstream log;
    RTT::Logger::Instance()->setStdStream(log);
    Writer writer(std::move(target));
    ASSERT_TRUE(writer.push(row(1)));
    writer.finish();
    RTT::Logger::Instance()->setStdStream(std::cerr);
    EXPECT_EQ(1u, writer.lost());
    EXPECT_NE(std::string::npos, log.str().find("pipe': Broken pipe; no further rows are written")) << log.str();
}

TEST_F(ReportFile, APipeThatNobodyReadsIsNotWaitedFor) {
    ASSERT_EQ(0, mkfifo(name_.c_str(), 0600));
    EXPECT_EQ(nullptr, openFile(name_, error_));
    EXPECT_EQ("nobody reads from this pipe", error_);
}

TEST_F(ReportFile, APipeTakesMoreThanItHolds) {
    ASSERT_EQ(0, mkfifo(name_.c_str(), 0600));
    const int reader = open(name_.c_str(), O_RDONLY | O_NONBLOCK);
    std::unique_ptr<TextTarget> target = openFile(name_, error_);
    ASSERT_NE(nullptr, target) << error_;
    std::string text(300000, 'x');
    std::thread writing([&] {
        put(*target, text);
        target.reset();
    });
    ASSERT_EQ(0, fcntl(reader, F_SETFL, 0));
    char part[1000];
    std::size_t got = 0;
    for (ssize_t more; (more = read(reader, part, sizeof part)) > 0;) got += static_cast<std::size_t>(more);
    writing.join();
    close(reader);
    EXPECT_EQ(text.size(), got);
}

}  // namespace
