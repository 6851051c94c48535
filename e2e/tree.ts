// The tree of a page for screen readers, as lines, and the changes between two trees.
import type { Page } from '@playwright/test'
import { createHash } from 'node:crypto'

/** Longer lists of these are cut, so that a further card, map or item changes nothing here. */
const shown: { readonly [role: string]: number } = {
  ...{ listitem: 5, row: 5, option: 5, link: 5, treeitem: 5, article: 5 },
  ...{ cell: 8, columnheader: 8, gridcell: 8 },
}
/** Elements that are cut from these lists. */
const late = ':is(li, tr, option, a, article):nth-of-type(n + 6), :is(td, th):nth-of-type(n + 9)'

/** Text that differs from run to run. */
const varying: readonly (readonly [RegExp, string])[] = [
  [/localhost:\d+/g, 'localhost'],
  [
    /\b\d{1,2} (January|February|March|April|May|June|July|August|September|October|November|December)( \d{4})?\b/g,
    'DATE',
  ],
  [/\b\d{1,2}:\d{2}(:\d{2})?\b( [AP]M\b)?/g, 'TIME'],
]

const indentOf = (line: string) => line.search(/\S/)
const roleOf = (line: string) => /^ *- '?(\w+)/.exec(line)?.[1] ?? ''

/** Lines without the blocks, which Blockly describes, and with the first items of long lists. */
export function shortened(lines: readonly string[]): string[] {
  const kept: string[] = []
  /** Indentation of a line whose lines below it are left out. */
  let above = Infinity
  const counts: Map<string, number>[] = []
  for (const line of lines) {
    // A page that loads has no lines; the place for messages about the network comes three seconds later.
    if (line === '' || line === '- status') continue
    const indent = indentOf(line)
    if (indent > above) continue
    above = Infinity
    const depth = indent / 2
    counts.length = depth + 1
    const role = roleOf(line)
    const count = ((counts[depth] ??= new Map()).get(role) ?? 0) + 1
    counts[depth].set(role, count)
    const most = shown[role] ?? Infinity
    if (count > most) {
      above = indent
      if (count === most + 1) kept.push(`${' '.repeat(indent)}- more of ${role}`)
    } else {
      if (/^ *- application "Blocks":$/.test(line)) above = indent
      kept.push(line)
    }
  }
  return kept
}

/** Facts that a tree of Playwright's leaves out: values of sliders, bounds, the current item, descriptions, chosen options. */
const detailsOf = (page: Page): Promise<readonly string[]> =>
  page.evaluate((cut) => {
    const aria = ['current', 'valuetext', 'valuenow', 'valuemin', 'valuemax', 'disabled', 'invalid', 'sort']
    const names = [...aria.map((name) => `aria-${name}`), 'title', 'placeholder', 'min', 'max', 'step']
    const nameOf = (one: Element) =>
      (one.getAttribute('aria-label') ?? one.textContent).trim().replaceAll(/\s+/g, ' ').slice(0, 60)
    const isShown = (one: Element) => one.checkVisibility() && !one.closest(`.injectionDiv, ${cut}`)
    const facts = [...document.querySelectorAll(names.map((name) => `[${name}]`).join())]
      .filter(isShown)
      .flatMap((one) =>
        names
          .filter((name) => one.hasAttribute(name))
          .map((name) => `= ${nameOf(one)} ${name.replace('aria-', '')}: ${one.getAttribute(name)!}`),
      )
    const chosen = [...document.querySelectorAll('select')]
      .filter(isShown)
      .map(
        (one) =>
          `= ${one.getAttribute('aria-label') ?? ''} chosen: ${one.selectedOptions[0]?.text.trim() ?? ''}`,
      )
    return [...facts, ...chosen]
  }, late)

/**
 * Drawings, which a screen reader leaves out: how many elements of each tag with which attributes. Values of attributes are
 * numbers of a layout, so they do not count; words in a drawing do.
 */
const drawnOn = (page: Page): Promise<readonly string[]> =>
  page.evaluate((cut) => {
    const isLook = /^(class|style|id|role|tabindex|xmlns|aria-.*|data-.*)$/
    const counts = new Map<string, number>()
    for (const one of document.querySelectorAll('svg, svg *, [aria-hidden="true"] *')) {
      if (!one.checkVisibility() || one.closest(`.injectionDiv, ${cut}`)) continue
      const names = [...one.attributes].map(({ name }) => name).filter((name) => !isLook.test(name))
      const words = one.childElementCount === 0 ? one.textContent.trim() : ''
      const line = `~ ${one.tagName.toLowerCase()}(${names.toSorted().join(' ')}) ${words}`.trim()
      counts.set(line, (counts.get(line) ?? 0) + 1)
    }
    return [...counts].map(([line, count]) => `${line} × ${count}`).toSorted()
  }, late)

/** The page's tree for a screen reader and its drawings, as lines; text that differs from run to run is replaced. */
export async function treeOf(page: Page, hidden?: RegExp): Promise<readonly string[]> {
  const tree = (await page.locator('body').ariaSnapshot()).split('\n')
  const all = [...shortened(tree), ...(await detailsOf(page)), ...(await drawnOn(page))]
  const patterns = hidden
    ? [...varying, [new RegExp(hidden, `${hidden.flags.replace('g', '')}g`), '…'] as const]
    : varying
  return all.map((line) => patterns.reduce((text, [pattern, by]) => text.replaceAll(pattern, by), line))
}

/** Lines of `after` that `before` has not, with as many of each as there are more. */
function moreIn(after: readonly string[], before: readonly string[]): string[] {
  const left = new Map<string, number>()
  for (const line of before) left.set(line, (left.get(line) ?? 0) + 1)
  return after.filter((line) => {
    const count = left.get(line) ?? 0
    left.set(line, count - 1)
    return count <= 0
  })
}

/** So many lines that went are listed; of more, as where another page opens, a hash stands for them. */
const mostGone = 12

function goneLines(gone: readonly string[]): readonly string[] {
  const lines = gone.map((line) => `- ${line.trim().replace(/^- /, '')}`)
  if (lines.length <= mostGone) return lines
  const hash = createHash('sha256').update(lines.join('\n')).digest('hex').slice(0, 8)
  return [`- ${lines.length} lines (${hash})`]
}

/** Lines that went and lines that came. */
export const changesOf = (before: readonly string[], after: readonly string[]): readonly string[] => [
  ...goneLines(moreIn(before, after)),
  ...moreIn(after, before).map((line) => `+${line.replace(/^( *)- /, ' $1')}`),
]
