#!/usr/bin/env python3
"""Checks report pages: strict XML, balanced HTML, no address, no script, alternatives for pictures, unique ids.

   check_page.py PAGE...      exit 1 and a line for each fault
   check_page.py --self-test  the checker itself, on pages that must fail
"""
import html.parser
import re
import sys
import xml.parsers.expat

VOID = {'meta', 'img', 'br'}
FORBIDDEN = {'script', 'link', 'iframe', 'object', 'embed', 'base', 'form', 'video', 'audio'}
SECTIONS = ['Standard sphere', 'Data against fit', 'Where the error is', 'Maps', 'Metrics', 'Samples', 'Material']


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.faults, self.open, self.ids, self.headings = [], [], set(), []

    def handle_starttag(self, tag, attributes):
        self.element(tag, dict(attributes))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.element(tag, dict(attributes))

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append('unbalanced </%s>' % tag)

    def handle_data(self, data):
        if self.open and self.open[-1] == 'h2':
            self.headings.append(data)
        if self.open and self.open[-1] == 'style' and re.search(r'@import|url\(', data):
            self.faults.append('the style sheet loads something')

    def element(self, tag, attributes):
        if tag in FORBIDDEN:
            self.faults.append('<%s>' % tag)
        if tag == 'img' and not attributes.get('alt'):
            self.faults.append('<img> without alt')
        if tag == 'svg' and not (attributes.get('aria-label') or attributes.get('aria-hidden')):
            self.faults.append('<svg> without a label')
        name = attributes.get('id')
        if name in self.ids:
            self.faults.append('id %s used twice' % name)
        if name:
            self.ids.add(name)
        for key, value in attributes.items():
            self.attribute(tag, key, value or '')

    def attribute(self, tag, key, value):
        if key.startswith('on'):
            self.faults.append('%s on <%s>' % (key, tag))
        if key in ('src', 'href', 'xlink:href') and not value.startswith('data:image/png;base64,'):
            self.faults.append('<%s %s="%s">' % (tag, key, value[:60]))
        if key not in ('aria-label', 'alt', 'content') and re.search(r'https?:|//', value) and not value.startswith('data:'):
            self.faults.append('address in %s of <%s>' % (key, tag))
        if 'url(' in value and not value.startswith('url(#'):
            self.faults.append('%s of <%s> loads something' % (key, tag))


def faults_of(text):
    page = Page()
    page.feed(text)
    page.close()
    page.faults += ['<%s> left open' % tag for tag in page.open]
    page.faults += ['no section "%s"' % s for s in SECTIONS if s not in page.headings]
    try:
        xml.parsers.expat.ParserCreate().Parse(text.encode(), True)
    except xml.parsers.expat.ExpatError as error:
        page.faults.append('not well-formed XML: %s' % error)
    return page.faults


def self_test():
    good = '<html><body>%s</body></html>' % ''.join('<h2>%s</h2>' % s for s in SECTIONS)
    bad = ['<p>', '<img src="data:image/png;base64,AA"/>', '<img alt="a" src="a.png"/>', '<script></script>',
           '<svg></svg>', '<p id="a"/><p id="a"/>', '<p onclick="a"/>', '<style>@import "a";</style>', '&nbsp;',
           '<p style="background:url(a)"/>', '<a href="https://example.com">a</a>', '<p data-a="http://a"/>', '<p>a & b</p>']
    assert not faults_of(good), faults_of(good)
    for part in bad:
        assert faults_of(good.replace('</body>', part + '</body>')), 'accepted ' + part
    assert faults_of(good.replace('Metrics', 'metrics'))


def main(arguments):
    if arguments == ['--self-test']:
        self_test()
        return 0
    count = 0
    for path in arguments:
        with open(path, encoding='utf-8') as file:
            for fault in faults_of(file.read()):
                print('%s: %s' % (path, fault))
                count += 1
    return 1 if count or not arguments else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
