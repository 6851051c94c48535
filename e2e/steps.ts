// Steps through a feature. Each changes the page's tree for screen readers; its file in `trees/` lists the changes.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import type { Child } from './child.ts'
import { expect, test } from './gate/gate.ts'
import { changesOf, treeOf } from './tree.ts'

/** Steps by their names; each begins where the one before it ends. */
export interface Steps {
  readonly [step: string]: (child: Child) => Promise<unknown>
}

interface Options {
  /** Matches text that differs from run to run: codes, random names. Written as `…`. */
  readonly hides?: RegExp
}

/** `npm run trees` writes the files instead of comparing with them. */
const isWriting = () => ['changed', 'all'].includes(test.info().config.updateSnapshots)

const fileOf = (name: string) => join(import.meta.dirname, 'steps/trees', `${name}.txt`)

/** Steps with the changes that each makes, as a file has them: `## step`, then a line a change. */
const parsed = (text: string): readonly (readonly [string, readonly string[]])[] =>
  text
    .split(/^## /m)
    .slice(1)
    .map((part) => part.trimEnd().split('\n'))
    .map(([step = '', ...changes]) => [step, changes])

const asText = (steps: readonly (readonly [string, readonly string[]])[]) =>
  steps.map(([step, changes]) => [`## ${step}`, ...changes].join('\n')).join('\n\n') + '\n'

/** The tree once it has not changed for half a second: only for writing, where there is nothing to wait for. */
async function settled(child: Child, hides?: RegExp): Promise<readonly string[]> {
  let tree = await treeOf(child.page, hides)
  for (let alike = 0; alike < 5;) {
    await child.page.waitForTimeout(100)
    const next = await treeOf(child.page, hides)
    alike = next.join('\n') === tree.join('\n') ? alike + 1 : 0
    tree = next
  }
  return tree
}

/** In ms. The page is read often, since most changes take two frames. */
const [timeout, intervals] = [10_000, [30]]

/** Goes through the steps. Each has to change something, and just as the file says. */
export async function goesThrough(child: Child, name: string, steps: Steps, { hides }: Options = {}) {
  const file = fileOf(name)
  const writes = isWriting()
  const recorded = new Map(existsSync(file) ? parsed(readFileSync(file, 'utf8')) : [])
  const written: [string, readonly string[]][] = []
  let before: readonly string[] = []
  for (const [step, act] of Object.entries(steps))
    await test.step(step, async () => {
      await act(child)
      let after: readonly string[] = []
      if (writes) {
        after = await settled(child, hides)
        written.push([step, changesOf(before, after)])
        expect(written.at(-1)![1], `"${step}" changes something`).not.toEqual([])
      } else {
        const look = async () => changesOf(before, (after = await treeOf(child.page, hides)))
        await expect
          .poll(look, { message: `after "${step}" (npm run trees writes ${name}.txt)`, timeout, intervals })
          .toEqual(recorded.get(step) ?? [])
      }
      before = after
    })
  if (!writes) return expect([...recorded.keys()]).toEqual(Object.keys(steps))
  mkdirSync(dirname(file), { recursive: true })
  writeFileSync(file, asText(written))
}
