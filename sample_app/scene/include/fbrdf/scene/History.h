// History.h - undo and redo: the documents that there were.
#pragma once
#include <fbrdf/scene/Document.h>

#include <deque>

namespace fbrdf::scene {

class History {
public:
    static constexpr size_t kKept = 100;  ///< steps that can be undone

    explicit History(Document first) : last_(std::move(first)) {}

    /// Takes what has become of the document, as one step. What happens between two calls is one
    /// step, so a drag that is followed at its end alone is one. What has not changed but for its
    /// moment is none.
    void follow(const Document& document);

    /// Goes back a step, or forth again: the document becomes what it was, but for its moment.
    /// False where there is no such step. What has not been followed yet is a step of its own.
    bool undo(Document& document);
    bool redo(Document& document);
    bool canUndo() const { return !before_.empty(); }
    bool canRedo() const { return !after_.empty(); }

private:
    bool go(std::deque<Document>& from, std::deque<Document>& to, Document& document);

    std::deque<Document> before_, after_;
    Document last_;
};

}  // namespace fbrdf::scene
