import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { hasProse, passagesOf } from './passages.ts'

/** Part of a file: its text, and whether the marker in it is prose. */
interface Segment {
  readonly text: string
  readonly isProse: boolean
}

const segment = (isProse: boolean, ...texts: string[]) =>
  fc.constantFrom(...texts).map((text): Segment => ({ text, isProse }))

const script = fc.oneof(
  segment(true, '// @\n', '/* @ */', '/** @ */\n', '/**\n * one line\n * @\n */\n', '//@\n'),
  segment(
    false,
    'a = "// @"\n',
    "a = '/* @ */'\n",
    'a = "\\"// @"\n',
    'a = `// @ ${b / 2} /* @ */`\n',
    'a = `${`// @`}`\n',
    'a = /\\/\\/ @/u.test(b)\n',
    'a = /[/*] @/\n',
    'a = b / 2 / "@".length\n',
    '\n',
  ),
)

const component = fc.oneof(
  segment(true, '<!-- @ -->', '<p>{a /* @ */}</p>\n', '<b\n  // @\n  title="a"\n>a</b>'),
  segment(
    false,
    '<p title="// @">https://host/@</p>\n',
    '<p>{"/* @ */"}</p>\n',
    '<p title={`// @`}>/* @ */</p>\n',
    '<p>// @</p>\n',
  ),
)

const style = fc.oneof(
  segment(true, '/* @ */\n', '/*\n @ */'),
  segment(
    false,
    'a { content: "/* @ */" }\n',
    'a { background: url(//host/*@*/) }\n',
    "a::after { content: '\\'/*@' }\n",
  ),
)

const markdown = fc.oneof(
  segment(true, '@\n\n', '## @\n\n', '- a\n- @\n\n', '**@**\n\n', '| a | @ |\n\n', '> @\n\n'),
  segment(
    false,
    '```ts\n@\n```\n\n',
    '`@`\n\n',
    '[a](https://host/@)\n\n',
    '<!-- a -->\n\n',
    'a\n\n    @\n\n',
  ),
)

/** Puts a numbered marker into each segment. */
function numbered(segments: readonly Segment[]) {
  const texts = segments.map(({ text }, index) => text.replaceAll('@', `marker${index}`))
  const prose = segments.flatMap(({ isProse }, index) => (isProse ? [`marker${index}`] : []))
  return { text: texts.join(''), prose }
}

/** The markers in the prose of a file, each with its line. */
const found = (path: string, text: string) =>
  passagesOf(path, text).flatMap((passage) =>
    passage.text
      .split('\n')
      .flatMap((words, index) =>
        (words.match(/marker\d+/g) ?? []).map((marker) => ({ marker, line: passage.line + index })),
      ),
  )

const lineOf = (text: string, marker: string) =>
  1 + text.split('\n').findIndex((line) => new RegExp(`${marker}(?!\\d)`).test(line))

const holdsFor = (path: string, segments: fc.Arbitrary<Segment>, around = (text: string) => text) =>
  fc.assert(
    fc.property(fc.array(segments, { maxLength: 12 }), (parts) => {
      const { text, prose } = numbered(parts)
      const file = around(text)
      expect(found(path, file)).toEqual(prose.map((marker) => ({ marker, line: lineOf(file, marker) })))
    }),
  )

describe('the prose of a file', () => {
  it('is the comments of TypeScript, each on its line, without strings, templates and regular expressions', () => {
    holdsFor('a.ts', script)
  })

  it('is the comments in the scripts of a component', () => {
    holdsFor('a.svelte', script, (text) => `<script lang="ts">\nlet a, b\n${text}\n</script>\n\n<p>a</p>\n`)
  })

  it('is the comments in the markup of a component, without text and attributes', () => {
    holdsFor('a.svelte', component, (text) => `<script>\nlet a\n</script>\n${text}`)
  })

  it('is the comments of styles, in files and in components', () => {
    holdsFor('a.css', style)
    holdsFor('a.svelte', style, (text) => `<p>a</p>\n<style>\n${text}\n</style>\n`)
  })

  it('is the paragraphs of a document, without code and addresses', () => {
    holdsFor('a.md', markdown)
  })

  it('is the comment lines of a shell script, without the interpreter', () => {
    expect(passagesOf('a.sh', '#!/bin/sh\n# First\n# second.\necho "#a"\n')).toEqual([
      { line: 2, text: ' First\n second.' },
    ])
  })

  it('is one passage for line comments that follow each other, and two with an empty line between', () => {
    const text = '// One\n// sentence.\n\n// Another.\nlet a // beside'
    expect(passagesOf('a.ts', text).map((passage) => passage.text)).toEqual([
      ' One\n sentence.',
      ' Another.',
      ' beside',
    ])
  })

  it('replaces code in a comment by one word, and keeps the number of lines', () => {
    const text = '/**\n * Calls `who()` or {@link what}.\n * ```ts\n * told()\n * ```\n * Ends.\n */'
    expect(passagesOf('a.ts', text)).toEqual([{ line: 1, text: '\n Calls X or X.\n\n\n\n Ends.\n ' }])
  })

  it('is not looked for in other kinds of files', () => {
    expect(hasProse('a.json')).toBe(false)
    expect(() => passagesOf('a.json', '{}')).toThrow('a.json: cannot extract prose from files of this kind.')
  })

  it('cannot be read from a component that cannot be parsed', () => {
    expect(() => passagesOf('a.svelte', '<!-- a --><p>{#if}</p>')).toThrow()
  })
})
