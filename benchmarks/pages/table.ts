import type { Table } from '../bench.ts'
import { exceptionFor, exceptions } from './exceptions.ts'
import { kinds } from './findings.ts'
import type { Looked } from './look.ts'

const meaning = [
  'overlap: lines or pictures over each other',
  'cut: what leaves its box, its drawing or its paper',
  'empty: a box with nothing in it',
  'language: words of the other language',
  'pale: contrast in luminance below 4.5 : 1, large letters below 3 : 1, so in grey as well',
  'small: letters below 7.5 pt (7 in drawings; on slides 12 and 9)',
  'file: tags, language, title, outline, words for figures, levels of headings, fonts, pages without marks',
]

const openOf = ({ id, findings }: Looked) => findings.filter((finding) => !exceptionFor(id, finding))

function rowOf(looked: Looked) {
  const { id, language, paper, pages, smallest, findings } = looked
  const open = openOf(looked)
  const counts = kinds.map((kind) => open.filter((finding) => finding.kind === kind).length || '–')
  return [
    id,
    language,
    paper,
    pages,
    ...counts,
    `${smallest.toFixed(1)} pt`,
    findings.length - open.length || '–',
  ]
}

/** Findings of a kind in one line, the first of them in words. */
const linesOf = (looked: Looked) =>
  kinds.flatMap((kind) => {
    const some = openOf(looked).filter((finding) => finding.kind === kind)
    if (some.length === 0) return []
    const told = some.slice(0, 4).map(({ what }) => what)
    const more = some.length > told.length ? [`and ${some.length - told.length} more`] : []
    return [`${looked.id}, ${looked.language}, ${looked.paper}: ${kind}: ${[...told, ...more].join(', ')}`]
  })

/** What was found, a row an item, and all that is open in words. */
export function tableOf(all: readonly Looked[]): Table {
  const open = all.flatMap(linesOf)
  const meant = exceptions.map(
    ({ kind, items, what, because }) =>
      `Meant to be so (${kind}, ${items?.join(', ') ?? 'everywhere'}, /${what.source}/): ${because}`,
  )
  return {
    title: 'Every printed page, looked at',
    how: 'Each item’s page in print media, in both languages and on its papers, measured line by line in Chromium; and the files of `botgarten print`, read back. First a page with a mistake of each sort is measured: it ends here where one is overlooked.',
    columns: ['item', 'language', 'paper', 'pages', ...kinds, 'smallest letters', 'meant to be so'],
    rows: all.map(rowOf),
    notes: [meaning.join(' · '), ...meant, ...(open.length > 0 ? open : ['Nothing is open.'])],
  }
}
