// Rooms: materials
// By address: a window that is printed is opened by its address.
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { globSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { sample } from '@botgarten/numbers/testing'
import type { Page } from '@playwright/test'
import { expect, test } from '../house.ts'
import { readPdf } from '../pdf.ts'
import { oneOfEachKind } from '../printed.ts'
import { languagesOf } from '../words.ts'

interface Held {
  readonly type: string
  readonly id: string
  readonly fields?: { readonly [name: string]: string }
  readonly values?: { readonly [name: string]: Held }
}

const content = new URL('../../content/', import.meta.url)
const read = (file: string): unknown => JSON.parse(readFileSync(new URL(file, content), 'utf8'))

const decks = globSync('materials/slides/*/item.json', { cwd: content }).map(
  (file) => (read(file) as { readonly id: string }).id,
)

/** Sets of cards that are printed with hints, and how many backs each has. */
const cardSets = globSync('materials/card/*/de.md', { cwd: content })
  .map((file) => ({
    id: file.replace(/^.*?\d+-([^/]+)\/.*$/, '$1'),
    backs: readFileSync(new URL(file, content), 'utf8').split('side=back').length - 1,
  }))
  // The back of a card with a map is a table for runs, without hints.
  .filter(({ id, backs }) => backs > 0 && !id.startsWith('q-'))

const home = 'https://botgarten.example.org'

async function opensPaper(page: Page, item: string, option = 'paper=a4', address = home) {
  await page.goto(`/materials/${item}?${option}&address=${address}`)
  await page.locator('html[data-print=ready]').waitFor({ state: 'attached' })
}

for (const language of languagesOf(import.meta.filename))
  test.describe(`on paper, in ${language}`, () => {
    test.use({ language })

    test('on the blocks of a front stand the numbers of its program, large enough, and nothing of a card is cut', async ({
      page,
    }) => {
      const wrong: string[] = []
      const shown = new Map<string, string>()
      for (const id of ['network-cards', 'first-drive-cards', 'sorting-cards-lab']) {
        await opensPaper(page, `card/${id}`, 'paper=a5')
        wrong.push(...(await page.evaluate(smallOrCut)))
        for (const [card, said] of await page.evaluate(blocksByCard)) shown.set(card, said)
      }
      expect(shown.size).toBeGreaterThan(10)
      expect(shown.get('chameleon')).not.toMatch(/distance|abstand/i)
      expect([...wrong, ...[...shown].flatMap(numbersOfNoProgram)]).toEqual([])
    })

    test('on every card the last hint, which is the solution, is upside down, and no other one', async ({
      page,
    }) => {
      for (const { id, backs } of cardSets) {
        await opensPaper(page, `card/${id}`, 'paper=a5')
        const turned = await page.evaluate(hintsUpsideDown)
        expect([id, turned.length]).toEqual([id, backs])
        expect(turned.filter(([, hints]) => String(hints) !== 'false,false,true')).toEqual([])
      }
    })
  })

/** Of each card by its name: does its hint run from right to left? */
function hintsUpsideDown(): (readonly [card: string | null, isTurned: readonly boolean[]])[] {
  const range = document.createRange()
  const boxOf = (text: Node, at: number) => {
    range.setStart(text, at)
    range.setEnd(text, at + 1)
    return range.getBoundingClientRect()
  }
  return [...document.querySelectorAll('.a-card')].flatMap((card) => {
    const hints = [...card.querySelectorAll('.hints li')].map((hint) => {
      const texts = document.createTreeWalker(hint, NodeFilter.SHOW_TEXT, (node) =>
        node.textContent!.trim().length > 1 ? NodeFilter.FILTER_ACCEPT : NodeFilter.FILTER_SKIP,
      )
      const first = texts.nextNode()!
      const start = first.textContent!.search(/\S/)
      return boxOf(first, start).left > boxOf(first, start + 1).left
    })
    return hints.length > 0 ? [[card.ariaLabel, hints] as const] : []
  })
}

/** Words on blocks below 8 pt, and boxes that hold more than is seen. */
function smallOrCut(): string[] {
  const cards = [...document.querySelectorAll<HTMLElement>('.a-card')]
  const heightOf = (text: SVGTextElement) =>
    (parseFloat(getComputedStyle(text).fontSize) * text.getBoundingClientRect().height) /
    text.getBBox().height
  return cards.flatMap((card) => {
    const name = card.ariaLabel
    const body = card.querySelector('.body')!
    const texts = [...card.querySelectorAll<SVGTextElement>('.columns .blocks text')]
    const small = texts.filter((text) => text.textContent.trim() && (heightOf(text) * 72) / 96 < 7.95)
    const cut = body.scrollHeight > body.clientHeight + 1 || body.scrollWidth > body.clientWidth + 1
    // Its row is as high as one line: a second one would lie over the story.
    const long = [...body.querySelectorAll('.title')].filter(
      (one) => one.scrollHeight > one.clientHeight + 20,
    )
    return [
      ...long.map(() => `${name}: its title has two lines`),
      ...small.map(
        (text) => `${name}: “${text.textContent}” has ${((heightOf(text) * 72) / 96).toFixed(1)} pt`,
      ),
      ...(cut ? [`${name} is cut`] : []),
    ]
  })
}

const cards = globSync('cards/*/*/card.json', { cwd: content }).map((file) => file.replace('/card.json', ''))

/** What blocks let a child choose, where its words have a number in them: no program types that. */
const choices = globSync('words/*/blocks*.json', { cwd: content })
  .flatMap((file) => Object.values((read(file) as { readonly choice?: object }).choice ?? {}) as string[])
  .filter((words) => /\d/.test(words) && /\p{L}{2}/u.test(words))
  .map((words) => words.replace(/\s+/g, ' '))

const withoutChoices = (said: string) =>
  choices.reduce((rest, words) => rest.replaceAll(words, ''), said.replace(/\s+/g, ' '))

/** Numbers on the blocks of a card that its programs do not have. */
function numbersOfNoProgram([card, said]: readonly [string, string]): string[] {
  const folder = cards.find((one) => one.endsWith(`-${card}`))!
  const own = ['start', 'solution'].flatMap((file) => typed(read(`${folder}/${file}.json`)))
  const numbers = withoutChoices(said).match(/(?<![\w.])\d+(?![\w.])/g) ?? []
  return numbers.filter((number) => !own.includes(number)).map((number) => `${card}: ${number}`)
}

test.describe('in the longer of the languages', () => {
  test.use({ language: 'de' })

  test('whole programs, nets and the flow diagram can be read, and no word leaves its box', async ({
    page,
  }) => {
    const wrong: string[] = []
    for (const [item, least] of [
      ['sheet/q-program', 8],
      ['sheet/q-flow', 8],
      ['solution/solutions-network', 7],
    ] as const) {
      await opensPaper(page, item)
      wrong.push(...(await page.evaluate(smallerThan, least)))
    }
    expect(wrong).toEqual([])
  })
})

test.describe('in the longer of the languages, on slides', () => {
  test.use({ language: 'de' })

  test('nothing of a slide is cut, and no words of it are small', async ({ page }) => {
    const wrong: string[] = []
    for (const id of decks) {
      await opensPaper(page, `slides/${id}`)
      wrong.push(...(await page.evaluate(wrongOnSlides)).map((one) => `${id}: ${one}`))
    }
    expect(decks.length).toBeGreaterThan(5)
    expect(wrong).toEqual([])
  })
})

/** Slides that hold more than is seen, or are made so small to hold it that its words have less than 18 pt of 27. */
function wrongOnSlides(): string[] {
  return [...document.querySelectorAll<HTMLElement>('.leaf > .box')].flatMap((box, at) => [
    ...(box.scrollHeight > box.clientHeight + 1 ? [`slide ${at + 1} is cut`] : []),
    ...(Number(box.dataset['zoom']) < 18 / 27 ? [`slide ${at + 1} has ${box.dataset['zoom']}`] : []),
  ])
}

/** Words on blocks, beside nodes and in boxes that have less pt than this, and boxes too small for theirs. */
function smallerThan(least: number): string[] {
  const zoomOf = (element: Element) => (element as Element & { currentCSSZoom: number }).currentCSSZoom
  const scaleOf = (text: Element) =>
    text instanceof SVGTextElement
      ? text.getBoundingClientRect().height / text.getBBox().height
      : zoomOf(text)
  const words = [...document.querySelectorAll('.blocks text, .net .label > *, .flow-diagram :is(small, b)')]
  const sizes = words
    // What is in a folded block is not shown.
    .filter((word) => word.textContent.trim() !== '' && word.getBoundingClientRect().height > 0)
    .map((word) => ({
      word: word.textContent.trim(),
      pt: (parseFloat(getComputedStyle(word).fontSize) * scaleOf(word) * 72) / 96,
    }))
  const boxes = [...document.querySelectorAll('.flow-diagram li')]
  const full = boxes.filter((box) => box.scrollHeight > box.clientHeight || box.scrollWidth > box.clientWidth)
  return [
    ...(sizes.length === 0 ? ['no words'] : []),
    ...sizes.filter(({ pt }) => pt < least - 0.05).map(({ word, pt }) => `“${word}” has ${pt.toFixed(1)} pt`),
    ...full.map((box) => `“${box.textContent.trim()}” leaves its box`),
  ]
}

/** What stands on the blocks of each front, by the card's id. */
function blocksByCard(): [string, string][] {
  return [...document.querySelectorAll('.a-card:has(.columns .blocks)')].map((card) => [
    card.querySelector('.paper-code a')!.getAttribute('href')!.split('/').at(-1)!,
    [...card.querySelectorAll('.columns .blocks')].map((one) => one.ariaLabel).join(' '),
  ])
}

/** All values of fields in a program, and the numbers in them: `ULTRASONIC_PORT_2` says 2. */
function typed(program: unknown): string[] {
  const all: string[] = []
  JSON.stringify(program, (key, value: unknown) => {
    if (key === 'fields')
      for (const one of Object.values((value as Held['fields'])!)) all.push(one, ...(one.match(/\d+$/) ?? []))
    return value
  })
  return all
}

test('on what is printed of each kind every link leads to the address that was given', async ({
  page,
  house,
}) => {
  const { links } = await printed(page, `${home}/school`, [...oneOfEachKind, game])
  const ours = links.filter(({ url }) => /\/(lab|materials)\//.test(url))
  expect(ours.filter(({ url }) => !url.startsWith(`${home}/school/`))).toEqual([])
  expect(links.filter(({ url }) => url.startsWith(house))).toEqual([])
  expect(ours).toContainEqual({ id: 'one-day', url: `${home}/school/materials/worksheet/evaluation-poster` })
})

test('without an address links are names with numbers, and none leads to the machine that prints', async ({
  page,
  house,
}) => {
  const { links, texts } = await printed(page, '', sample([...oneOfEachKind, game], 3))
  expect(links.filter(({ url }) => url.startsWith(house))).toEqual([])
  expect(texts.get('one-day')).toContain('Slides 1 (How does your robot learn?)')
  expect(texts.get('one-day')).toContain('Poster (6.3: What was the most fun?)')
})

const game = ['kit', 'sorting-game'] as const

/** Links and words in the PDFs of these items. */
async function printed(page: Page, address: string, items: readonly (readonly [kind: string, id: string])[]) {
  const links: { id: string; url: string }[] = []
  const texts = new Map<string, string>()
  for (const [kind, id] of items) {
    await opensPaper(page, `${kind}/${id}`, 'paper=a4', address)
    const { pages } = await readPdf(await page.pdf({ preferCSSPageSize: true, printBackground: true }))
    links.push(...pages.flatMap((one) => one.links.map((url) => ({ id: id, url }))))
    texts.set(id, pages.map(({ text }) => text).join(' '))
  }
  return { links, texts }
}

test('a kind is printed from its own page as large as its paper, without the bar', async ({ page }) => {
  const sizes = { a4: [210, 297], a5: [148, 210], '16:9': [339, 191] }
  const wrong: string[] = []
  for (const [kind, id] of sample(oneOfEachKind, 4)) {
    await page.goto(`/materials/${kind}/${id}`)
    const article = page.locator('.material[aria-busy=false]')
    await expect(article).toBeVisible()
    const paper = (await article.getAttribute('data-paper')) as keyof typeof sizes
    const end = (await article.locator(':is(.on, .words, .a-card > .body)').last().innerText())
      .trim()
      .split(/\s+/)
    const pdf = await readPdf(await page.pdf({ preferCSSPageSize: true, printBackground: true }))
    for (const { width, height, text } of pdf.pages) {
      if (String([width, height]) !== String(sizes[paper])) wrong.push(`${id}: ${width} × ${height}`)
      if (/\bDE\b.*\bEN\b/.test(text)) wrong.push(`${id}: the bar is printed`)
      if (text.trim() === '') wrong.push(`${id}: an empty page`)
    }
    const all = pdf.pages.map(({ text }) => text.replaceAll(/\s/g, '')).join('')
    if (!all.includes(end.at(-1)!)) wrong.push(`${id}: its end is cut`)
  }
  expect(wrong).toEqual([])
})

test('printing that is stopped leaves nothing in the temporary folder', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-stopped-'))
  try {
    const cli = join(import.meta.dirname, '../../apps/cli/botgarten.ts')
    const printing = spawn(
      process.execPath,
      [cli, 'print', 'all', '--lang', 'de', '--out', join(folder, 'out')],
      {
        env: { ...process.env, TMPDIR: folder },
      },
    )
    await expect.poll(() => readdirSync(folder)).toContainEqual(expect.stringMatching(/^botgarten-browser/))
    printing.kill('SIGINT')
    await once(printing, 'exit')
    expect(readdirSync(folder)).toEqual(['out'])
  } finally {
    rmSync(folder, { recursive: true })
  }
})
