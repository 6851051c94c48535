// The tree of a page for screen readers, as lines, and the changes between two trees.
import type { Page } from '@playwright/test'

/** Longer lists of these are cut, so that a further card, map or item changes nothing here. */
const long = ['listitem', 'row', 'option', 'link', 'treeitem', 'article']
const shown = 3

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

/** Lines without the blocks, which Blockly describes, and with three of the items of a long list. */
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
    if (long.includes(role) && count > shown) {
      above = indent
      if (count === shown + 1) kept.push(`${' '.repeat(indent)}- more of ${role}`)
    } else {
      if (/^ *- application "Blocks":$/.test(line)) above = indent
      kept.push(line)
    }
  }
  return kept
}

/** Facts that a tree of Playwright's leaves out: values of sliders and pictures, the current item, descriptions. */
const detailsOf = (page: Page): Promise<readonly string[]> =>
  page.evaluate(() => {
    const names = ['aria-current', 'aria-valuetext', 'aria-valuenow', 'aria-disabled', 'title', 'placeholder']
    const nameOf = (one: Element) =>
      (one.getAttribute('aria-label') ?? one.textContent).trim().replaceAll(/\s+/g, ' ').slice(0, 60)
    return [...document.querySelectorAll(names.map((name) => `[${name}]`).join())]
      .filter((one) => one.checkVisibility() && !one.closest('.injectionDiv'))
      .flatMap((one) =>
        names
          .filter((name) => one.hasAttribute(name))
          .map((name) => `= ${nameOf(one)} ${name.replace('aria-', '')}: ${one.getAttribute(name)!}`),
      )
  })

/** The page's tree for a screen reader, a line for each element; text that differs from run to run is replaced. */
export async function treeOf(page: Page, hidden?: RegExp): Promise<readonly string[]> {
  const tree = (await page.locator('body').ariaSnapshot()).split('\n')
  const all = [...shortened(tree), ...(await detailsOf(page))]
  const patterns = hidden ? [...varying, [hidden, '…'] as const] : varying
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

/** Lines that went and lines that came. */
export const changesOf = (before: readonly string[], after: readonly string[]): readonly string[] => [
  ...moreIn(before, after).map((line) => `- ${line.trim().replace(/^- /, '')}`),
  ...moreIn(after, before).map((line) => `+${line.replace(/^( *)- /, ' $1')}`),
]
