// Which features of CSS our styles use: properties, their values, at-rules and selectors, each with its entry in MDN's table.
import postcss, { type AtRule, type ChildNode } from 'postcss'
import { entryAt } from './support.mjs'
import type { Use } from './uses.ts'

/** A file with styles: CSS, or a component with a block of it. */
export interface Sheet {
  readonly file: string
  readonly text: string
}

const has = (path: string) => entryAt(path)?.['__compat'] !== undefined
const types = Object.keys(entryAt('css.types') ?? {})

/** The CSS of a file; of a component its blocks of styles. */
const cssOf = ({ file, text }: Sheet): readonly string[] =>
  file.endsWith('.svelte')
    ? [...text.matchAll(/<style[^>]*>([\s\S]*?)<\/style>/g)].map(([, css]) => css!)
    : [text]

/** Names in a value that are no functions: keywords and units are among them, names of animations too. */
const wordsIn = (value: string) => value.match(/(?<![\w#.-])[a-z][a-z-]*(?![\w-]*\()/g) ?? []
const functionsIn = (value: string) => [...value.matchAll(/([a-z-]+)\(/g)].map(([, name]) => name!)

/** Entries of the table for a node of a style sheet, each with the name that it has in our report. */
function entriesOf(node: ChildNode): readonly (readonly [name: string, path: string])[] {
  if (node.type === 'atrule') return [[`@${node.name}`, `css.at-rules.${node.name}`]]
  if (node.type === 'rule')
    return [...node.selector.matchAll(/::?([a-z-]+)/g)].map(([found, name]) => [
      found,
      `css.selectors.${name}`,
    ])
  if (node.type !== 'decl' || node.prop.startsWith('--')) return []
  const { prop, value, parent } = node
  // A descriptor, such as the size of a page.
  if (parent?.type === 'atrule') {
    const { name } = parent as AtRule
    return name === 'page' || name === 'font-face'
      ? [[`@${name} ${prop}`, `css.at-rules.${name}.${prop}`]]
      : []
  }
  const own = `css.properties.${prop}`
  return [
    [prop, own],
    ...wordsIn(value).map((word) => [`${prop}: ${word}`, `${own}.${word}`] as const),
    ...functionsIn(value).flatMap((name) => {
      const path = [
        `${own}.${name}`,
        `css.types.${name}`,
        ...types.map((one) => `css.types.${one}.${name}`),
      ].find(has)
      return path === undefined ? [] : [[`${name}()`, path] as const]
    }),
  ]
}

/** Features that styles use and that the table knows. */
export function stylesIn(sheets: readonly Sheet[]): readonly Use[] {
  const found = new Map<string, { path: string; places: Set<string> }>()
  for (const sheet of sheets)
    for (const css of cssOf(sheet))
      postcss.parse(css).walk((node) => {
        for (const [name, path] of entriesOf(node).filter(([, one]) => has(one))) {
          const use = found.get(name) ?? { path, places: new Set<string>() }
          use.places.add(sheet.file)
          found.set(name, use)
        }
      })
  return [...found]
    .map(([name, { path, places }]) => ({ name, paths: [path], places: [...places].toSorted() }))
    .toSorted((a, b) => (a.name < b.name ? -1 : 1))
}
