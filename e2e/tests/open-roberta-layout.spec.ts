// Rooms: open-roberta
import { readdirSync } from 'node:fs'
import { sample } from '@botgarten/numbers/testing'
import type { Page } from '@playwright/test'
import { xmlTree } from '../../packages/programs/testing/xml-tree.ts'
import { Comer, openRobertaFile } from '../child-open-roberta.ts'
import { expect, test } from '../house.ts'

const folder = new URL('../../packages/programs/testing/open-roberta/programs/', import.meta.url)

interface Stack {
  readonly x: number
  readonly y: number
  readonly starts: boolean
}

/** The stacks of a file, as its `<instance>` elements say. */
const stacksIn = (text: string): readonly Stack[] =>
  [...text.split('<config>')[0]!.matchAll(/<instance x="([^"]*)" y="([^"]*)">\s*<block type="([^"]*)"/g)].map(
    ([, x, y, type]) => ({ x: Number(x), y: Number(y), starts: type === 'robControls_start' }),
  )

const given = readdirSync(folder).map((file) => {
  const text = openRobertaFile(`programs/${file.replace(/\.xml$/, '')}`)
  return { name: file.replace(/\.xml$/, ''), text, stacks: stacksIn(text) }
})
const isOut = ({ x, y }: Stack) => x < 0 || y < 0
/** Real files in which something could be hidden: by another stack, or since it stands left of or above the paper. */
const files = [
  ...given.filter(({ stacks }) => stacks.length > 1),
  ...given.filter(({ stacks }) => stacks.length === 1 && stacks.every(isOut)).slice(0, 4),
]

/** Blocks of a large program come in slices, and what is far from the view is not drawn: here all of it is. */
const blocksIn = (text: string) => text.split('<config>')[0]!.match(/<(block|shadow) /g)!.length
const nothingFar = '.editor-far.editor-far { display: inline !important }'

/** Where the stacks are drawn, each with all its blocks, in px of the page. */
const drawn = (page: Page) =>
  page.locator('.program:not([hidden]) svg.blocklySvg .blocklyBlockCanvas').evaluate((canvas) =>
    [...canvas.children]
      .filter((stack) => stack.matches('.blocklyDraggable'))
      .map((stack) => {
        const parts = [...stack.querySelectorAll('.blocklyPath')].map((path) => path.getBoundingClientRect())
        return {
          left: Math.min(...parts.map(({ left }) => left)),
          top: Math.min(...parts.map(({ top }) => top)),
          right: Math.max(...parts.map(({ right }) => right)),
          bottom: Math.max(...parts.map(({ bottom }) => bottom)),
        }
      }),
  )

type Drawn = Awaited<ReturnType<typeof drawn>>

/** Pairs that cover more of each other than an outline. */
const overlaps = (stacks: Drawn) =>
  stacks.flatMap((a, i) =>
    stacks
      .slice(i + 1)
      .filter(
        (b) => a.left < b.right - 2 && b.left < a.right - 2 && a.top < b.bottom - 2 && b.top < a.bottom - 2,
      ),
  ).length

const firstWord = (page: Page) =>
  page.locator('.program:not([hidden]) .blocklyBlockCanvas > .blocklyDraggable').getByText(/^(when|wenn)$/)

const some = sample(files, 5)

test(`no stack lies on another in ${some.length} real files, and the start block is in sight`, async ({
  child,
  page,
}) => {
  expect(files).toHaveLength(27)
  const comer = new Comer(child)
  await child.opensLab('free')
  await page.addStyleTag({ content: nothingFar })
  for (const { name, text, stacks } of some)
    await test.step(name, async () => {
      await comer.opens(`${name}.xml`, text)
      await comer.seesProgram(name)
      if (stacks.some(({ starts }) => starts)) await expect(firstWord(page).first()).toBeInViewport()
      await expect(page.locator('.program:not([hidden]) .blocklyPath')).toHaveCount(blocksIn(text))
      await expect.poll(async () => overlaps(await drawn(page)), name).toBe(0)
    })
})

test('one press tidies the stacks up, one takes it back, and the file is as it came', async ({
  child,
  page,
}) => {
  const comer = new Comer(child)
  const heap = openRobertaFile('programs/fork__progOriginals__ev3BasicFunctions')
  await comer.opensAtHome('Heap.xml', heap)
  await comer.seesProgram('Heap')
  const before = await drawn(page)
  const tidy = child.button('lab.tidy')
  await tidy.focus()
  await page.keyboard.press('Enter')
  await expect.poll(async () => new Set((await drawn(page)).map(({ left }) => Math.round(left))).size).toBe(1)
  await expect.poll(async () => overlaps(await drawn(page))).toBe(0)
  await expect(firstWord(page).first()).toBeInViewport()
  await child.presses('lab.undo')
  await expect.poll(() => drawn(page)).toEqual(before)
  const { text } = await comer.saves()
  expect(xmlTree(text)).toEqual(xmlTree(heap))
})
