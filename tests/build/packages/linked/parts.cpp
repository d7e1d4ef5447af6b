int linkedPart() { return 1; }
