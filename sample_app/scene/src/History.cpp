#include <fbrdf/scene/History.h>

namespace fbrdf::scene {

void History::follow(const Document& document)
{
    last_.moment = document.moment;
    if (last_ == document) {
        last_.materials = document.materials;  // where they are loaded
        return;
    }
    after_.clear();
    before_.push_back(std::move(last_));
    if (before_.size() > kKept) before_.pop_front();
    last_ = document;
}

bool History::go(std::deque<Document>& from, std::deque<Document>& to, Document& document)
{
    follow(document);
    if (from.empty()) return false;
    to.push_back(std::move(last_));
    last_ = std::move(from.back());
    from.pop_back();
    last_.moment = document.moment;
    document = last_;
    return true;
}

bool History::undo(Document& document)
{
    return go(before_, after_, document);
}

bool History::redo(Document& document)
{
    return go(after_, before_, document);
}

}  // namespace fbrdf::scene
