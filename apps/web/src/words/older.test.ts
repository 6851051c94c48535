import { readFileSync } from 'node:fs'
import { runInNewContext } from 'node:vm'
import { promised } from '@botgarten/browsers/promised'
import { completeLanguages } from '@botgarten/messages/folder'
import { expect, test } from 'vitest'
import { inHouse } from '../../../../scripts/prepare/house.mjs'
import { entryAt, missingIn, versionsOf } from '../../../../scripts/browsers/support.mjs'
import { olderHtml, script } from '../../older.ts'

/** The APIs that the script looks for, in MDN's table. */
const probes = [
  'javascript.regular_expressions.lookbehind_assertion',
  'javascript.builtins.Array.toSorted',
  'css.types.color.color-mix',
]

/** A browser that runs the script of a document: the ids that it shows, at once and after its page has failed. */
function browser({ lookbehind = true, toSorted = true, colours = true, main = false } = {}) {
  const shown: string[] = []
  const button: { onclick?: () => void } = {}
  const getElementById = (id: string) =>
    Object.defineProperty({ getElementsByTagName: () => [button] }, 'hidden', {
      set: (hidden: boolean) => (hidden ? shown.splice(shown.indexOf(id), 1) : shown.push(id)),
    })
  const listeners = new Map<string, () => void>()
  const after: (() => void)[] = []
  runInNewContext(`${toSorted ? '' : 'delete Array.prototype.toSorted;'}${script}`, {
    document: { getElementById, getElementsByTagName: () => (main ? [{}] : []) },
    window: { addEventListener: (name: string, heard: () => void) => listeners.set(name, heard), CSS: {} },
    CSS: { supports: () => colours },
    RegExp: function (source: string) {
      if (!lookbehind) throw new SyntaxError('Invalid group')
      return new RegExp(source)
    },
    setTimeout: (then: () => void) => after.push(then),
  })
  const fails = (name: string) => {
    listeners.get(name)!()
    for (const then of after.splice(0)) then()
  }
  return { shown, fails, closes: () => button.onclick!(), listeners }
}

test('a promised browser shows nothing; one that lacks any of three APIs says that it is too old', () => {
  expect(browser().shown).toEqual([])
  for (const lack of [{ lookbehind: false }, { toSorted: false }, { colours: false }]) {
    const { shown, closes, listeners } = browser(lack)
    expect([shown, listeners.size]).toEqual([['older'], 0])
    closes()
    expect(shown).toEqual([])
  }
})

test('the three APIs are in every promised browser, and each browser has one of them since the promised version', () => {
  const entries = probes.map((path) => entryAt(path)!)
  expect(entries.flatMap((entry) => missingIn(entry, promised))).toEqual([])
  const { safari, firefox, chrome, edge } = promised
  const since = entries.map(versionsOf)
  expect([safari, firefox, chrome].map((version, at) => since.some((one) => one[at] === version))).toEqual([
    true,
    true,
    true,
  ])
  expect(edge).toBe(chrome)
})

test.each(['error', 'unhandledrejection'])('a page that never appears after an %s says so', (name) => {
  const { shown, fails } = browser()
  fails(name)
  expect(shown).toEqual(['older'])
  const page = browser({ main: true })
  page.fails(name)
  expect(page.shown).toEqual([])
})

test('the document has the message in every complete language, with the promised versions', () => {
  const html = olderHtml()
  for (const language of completeLanguages) expect(html.split(`<p lang="${language}">`)).toHaveLength(2)
  for (const version of Object.values(promised)) expect(html).toContain(version)
  expect(html.replace(script, '').replace(/<style>.*<\/style>/, '')).not.toMatch(/[{}]/)
  expect(html).toContain('<noscript><style>#older{display:block}')
})

test.each(['README.md', 'docs/running-a-class.md'])('%s names the promised versions', (file) => {
  const { safari, firefox, chrome, edge } = promised
  const text = readFileSync(inHouse(file), 'utf8').replaceAll(/\s+/g, ' ')
  expect(text).toContain(
    `Safari ${safari} (on an iPad too), Firefox ${firefox}, Chrome ${chrome} or Edge ${edge}, or a newer version`,
  )
})
