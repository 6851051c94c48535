import { timed } from '@botgarten/numbers/testing/processor'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { readFreeText } from './freeText.ts'
import type { FreeText } from './cardTypes.ts'

const text = (value: string) => ({ type: 'text', value })

test('headings, paragraphs, lists and links are read as a syntax tree', () => {
  expect(readFreeText('# Our school\n\nAsk **Ms Lee**: [mail](mailto:lee@school.example)\n\n- one')).toEqual([
    { type: 'heading', children: [text('Our school')] },
    {
      type: 'paragraph',
      children: [
        text('Ask '),
        { type: 'strong', children: [text('Ms Lee')] },
        text(': '),
        { type: 'link', href: 'mailto:lee@school.example', children: [text('mail')] },
      ],
    },
    {
      type: 'list',
      ordered: false,
      children: [{ type: 'listItem', children: [{ type: 'paragraph', children: [text('one')] }] }],
    },
  ])
})

test('a link that does something else than lead to a page or a person is its words', () => {
  for (const address of ['javascript:alert(1)', 'JaVaScRiPt:alert(1)', 'data:text/html,x', '//other.example'])
    expect(readFreeText(`[here](<${address}>)`)).toEqual([{ type: 'paragraph', children: [text('here')] }])
})

test('HTML and pictures are left out, words around them stay', () => {
  expect(readFreeText('a <script>b</script> ![c](https://other.example/c.png) d')).toEqual([
    { type: 'paragraph', children: [text('a '), text('b'), text(' '), text(' d')] },
  ])
  expect(readFreeText('<iframe src="https://other.example"></iframe>')).toEqual([])
})

test('whatever is written, only what the page can show comes out', () => {
  const kinds = new Set(['text', 'paragraph', 'strong', 'emphasis', 'listItem', 'list', 'heading', 'link'])
  const check = (nodes: FreeText) => {
    for (const node of nodes) {
      expect(kinds).toContain(node.type)
      if (node.type === 'link') expect(node.href).toMatch(/^(https?:\/\/|mailto:|tel:)/i)
      if ('children' in node) check(node.children)
    }
  }
  const piece = fc.constantFrom(
    '# ',
    '[x](',
    'javascript:',
    'https://a.example',
    ')',
    '<b>',
    '\n\n',
    '- ',
    '*',
    '`',
  )
  fc.assert(
    fc.property(fc.array(fc.oneof(piece, fc.string()), { maxLength: 12 }), (parts) =>
      check(readFreeText(parts.join(''))),
    ),
  )
})

/** Levels of a tree. */
const depthOf = (nodes: FreeText): number =>
  Math.max(0, ...nodes.map((node) => 1 + ('children' in node ? depthOf(node.children) : 0)))

test.each([
  ['4,000 quotes in each other', '>'.repeat(4000) + ' Ms Lee'],
  ['as many quotes as fit', '> '.repeat(50_000)],
  ['as many numbered lists as fit', '1. '.repeat(33_000)],
  [
    'lists, each a step further in',
    Array.from({ length: 300 }, (_, i) => `${' '.repeat(2 * i)}- a`).join('\n'),
  ],
  ['links that never end', '[a]('.repeat(25_000)],
])('%s are read within two seconds, and can be drawn', (_, markdown) => {
  const { result: tree, seconds } = timed(() => readFreeText(markdown))
  expect(seconds).toBeLessThan(2)
  expect(depthOf(tree)).toBeLessThan(50)
  if (markdown.includes('Ms Lee')) expect(JSON.stringify(tree)).toContain('Ms Lee')
})

test('quotes and lists that somebody means stay as they are', () => {
  const words = (nodes: FreeText): string =>
    nodes.map((node) => ('children' in node ? words(node.children) : node.value)).join('|')
  expect(words(readFreeText('> > > a\n\n- - b\n\n-1 c\n\n1) d'))).toBe('a|b|-1 c|d')
})
