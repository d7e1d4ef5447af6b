// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Messages byte by byte: those of the original toolchain for the types that it sends.
#include "raw_queue.hpp"
#include "transport_fixture.hpp"

#include <rtt/transports/mqueue/MQLib.hpp>
#include <rtt/transports/mqueue/MQSerializationProtocol.hpp>
#include <rtt/transports/mqueue/MQTemplateProtocol.hpp>
#include <rtt/types/StructTypeInfo.hpp>

#include <boost/serialization/vector.hpp>

#include <cstring>
#include <string>
#include <vector>

using namespace RTT;
using transport_test::queueName;
using transport_test::RawQueue;
using transport_test::readSoon;

namespace sent {

struct Row {
    int count = 0;
    char letter = 0;
    double value = 0;
    bool operator==(const Row& other) const {
        return count == other.count && letter == other.letter && value == other.value;
    }
};
struct Table {
    std::vector<Row> rows;
    std::string name;
};
struct Plain {
    int a = 0;
    double b = 0;
};
struct Marshalled {
    int value = 0;
};

template <class Archive>
void serialize(Archive& archive, Row& row, unsigned) {
    archive& boost::serialization::make_nvp("count", row.count);
    archive& boost::serialization::make_nvp("letter", row.letter);
    archive& boost::serialization::make_nvp("value", row.value);
}
template <class Archive>
void serialize(Archive& archive, Table& table, unsigned) {
    archive& boost::serialization::make_nvp("rows", table.rows) & boost::serialization::make_nvp("name", table.name);
}

/** Sends the negative value. */
class MarshalledProtocol : public mqueue::MQTemplateProtocolBase<Marshalled> {
public:
    std::pair<void const*, int> fillBlob(base::DataSourceBase::shared_ptr source, void* blob, int,
                                         void*) const override {
        const int value = -internal::DataSource<Marshalled>::narrow(source.get())->rvalue().value;
        std::memcpy(blob, &value, sizeof value);
        return {blob, static_cast<int>(sizeof value)};
    }
    bool updateFromBlob(const void* blob, int, base::DataSourceBase::shared_ptr target, void*) const override {
        int value = 0;
        std::memcpy(&value, blob, sizeof value);
        internal::AssignableDataSource<Marshalled>::narrow(target.get())->set().value = -value;
        return true;
    }
    unsigned int getSampleSize(base::DataSourceBase::shared_ptr, void*) const override { return sizeof(int); }
};

}  // namespace sent

namespace {

class MqueueFormats : public transport_test::WithTypes {
protected:
    MqueueFormats() {
        policy.transport = ORO_MQUEUE_PROTOCOL_ID;
        policy.name_id = queueName("format");
    }
    template <class T>
    static std::string memory(const T& value) {
        return std::string(reinterpret_cast<const char*>(&value), sizeof value);
    }
    /// The message that the sample becomes; `back` receives it.
    template <class T>
    std::string message(const T& sample, T& back) {
        OutputPort<T> out("out");
        EXPECT_TRUE(out.createStream(policy));
        RawQueue queue(policy.name_id);
        (void)queue.receive();  // the first one
        EXPECT_EQ(out.write(sample), WriteSuccess);
        const std::string sent = queue.receive();
        EXPECT_TRUE(queue.send(sent));  // for an input that begins with it, as an old one would
        InputPort<T> in("in");
        EXPECT_TRUE(in.createStream(policy));
        EXPECT_TRUE(queue.send(sent));
        EXPECT_TRUE(readSoon(in, back));
        return sent;
    }
    template <class T>
    void isMemory(const T& sample) {
        T back{};
        EXPECT_EQ(message(sample, back), memory(sample));
        EXPECT_EQ(back, sample);
    }
    ConnPolicy policy = ConnPolicy::buffer(4);
};

}  // namespace

TEST_F(MqueueFormats, NumbersAreTheirMemory) {
    isMemory(-5);
    isMemory(5U);
    isMemory(1.25);
    isMemory(1.25F);
    isMemory('x');
    isMemory(-5LL);
    isMemory(5ULL);
    isMemory(true);
}

TEST_F(MqueueFormats, ArraysAreTheirSizeAndTheirNumbers) {
    std::vector<double> back;
    EXPECT_EQ(message(std::vector<double>(), back), std::string(8, '\0'));
    const std::vector<double> three{1, 2, 3};
    EXPECT_EQ(message(three, back), memory(std::uint64_t{3}) + memory(1.0) + memory(2.0) + memory(3.0));
    EXPECT_EQ(back, three);
}

TEST_F(MqueueFormats, OtherTypesHaveAFingerprint) {
    std::string back;
    const std::string sent = message(std::string("tank"), back);
    EXPECT_EQ(back, "tank");
    EXPECT_EQ(sent.substr(8), memory(std::uint32_t{5}) + std::string("tank\0", 5));
    short number = 0;
    EXPECT_NE(message(short{1}, number).substr(0, 8), sent.substr(0, 8));
}

TEST_F(MqueueFormats, ATransporterOfATypekitDefinesThem) {
    auto& types = *types::Types();
    types.addType(new types::StructTypeInfo<sent::Row>("Row"));
    types.addType(new types::StructTypeInfo<sent::Table>("Table"));
    ASSERT_TRUE(types.type("Row")->hasProtocol(ORO_MQUEUE_PROTOCOL_ID)) << "the generic one";
    ASSERT_TRUE(types.type("Row")->addProtocol(ORO_MQUEUE_PROTOCOL_ID, new mqueue::MQSerializationProtocol<sent::Row>));
    EXPECT_FALSE(types.type("Row")->addProtocol(ORO_MQUEUE_PROTOCOL_ID, new mqueue::MQTemplateProtocol<sent::Row>));
    ASSERT_TRUE(
        types.type("Table")->addProtocol(ORO_MQUEUE_PROTOCOL_ID, new mqueue::MQSerializationProtocol<sent::Table>));
    sent::Row row, back;
    row.count = 3, row.letter = 'c', row.value = 0.5;
    const std::string bytes = memory(3) + "c" + memory(0.5);
    EXPECT_EQ(message(row, back), bytes) << "13 bytes";
    EXPECT_EQ(back, row);
    sent::Table table, tableBack;
    table.rows = {row, row};
    table.name = "abc";
    EXPECT_EQ(message(table, tableBack), memory(std::uint64_t{2}) + bytes + bytes + memory(std::uint64_t{3}) + "abc");
    EXPECT_EQ(tableBack.rows, table.rows);
    EXPECT_EQ(tableBack.name, "abc");
}

TEST_F(MqueueFormats, AMessageThatEndsTooEarlyIsRefused) {
    sent::Table table;
    std::string why;
    mqueue::MQSerializationProtocol<sent::Table> protocol;
    const std::string huge = memory(~std::uint64_t{0});
    const base::DataSourceBase::shared_ptr target(new internal::ReferenceDataSource<sent::Table>(table));
    for (const std::string& bytes : {std::string(), huge, huge + std::string(20, 'x'), std::string(17, '\0')})
        EXPECT_FALSE(protocol.updateFromBlob(bytes.data(), static_cast<int>(bytes.size()), target, nullptr));
}

TEST_F(MqueueFormats, AnyByteButZeroIsTrue) {
    const unsigned char seven = 7;
    bool value = false;
    mqueue::MessageReader(&seven, 1) >> value;
    EXPECT_TRUE(value);
    bool received = false;
    (void)message(true, received);
    EXPECT_TRUE(received);
}

TEST_F(MqueueFormats, AMarshallerDefinesThem) {
    auto& types = *types::Types();
    types.addType(new types::TemplateTypeInfo<sent::Plain>("Plain"));
    types.addType(new types::TemplateTypeInfo<sent::Marshalled>("Marshalled"));
    ASSERT_TRUE(types.type("Plain")->addProtocol(ORO_MQUEUE_PROTOCOL_ID, new mqueue::MQTemplateProtocol<sent::Plain>));
    ASSERT_TRUE(types.type("Marshalled")->addProtocol(ORO_MQUEUE_PROTOCOL_ID, new sent::MarshalledProtocol));
    sent::Plain plain, plainBack;
    plain.a = 1, plain.b = 2;
    EXPECT_EQ(message(plain, plainBack).size(), sizeof plain);
    EXPECT_EQ(plainBack.b, 2);
    sent::Marshalled marshalled, back;
    marshalled.value = 4;
    EXPECT_EQ(message(marshalled, back), memory(-4));
    EXPECT_EQ(back.value, 4);
}
