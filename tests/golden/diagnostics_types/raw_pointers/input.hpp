#pragma once
namespace bad {
struct Node {
    Node* next;
    const char* name;
    unsigned char* bytes;
    void* data;
    int& reference;
    int (*function)(int);
    int Node::*member;
};
}
