// Rooms: q-learning, app
import { Learner } from '../child-learning.ts'
import { expect, test } from '../house.ts'

// German words are the longest.
test.use({ language: 'de' })

const shapes = { railway: 1.6, forest: 1.6, city: 4 / 3, mars: 1.6 } as const
type Card = keyof typeof shapes

/** At these sizes the map has its share, unless its shape and the bars above leave less. */
const share = 0.45
const large = [
  [1366, 768],
  [1366, 625],
  [1024, 768],
  [1024, 670],
  [1024, 600],
  [640, 480],
] as const
/** A map of 4 to 3 as high as a low laptop leaves room. */
const lessFor = (card: Card, width: number, height: number) =>
  card === 'city' && width === 1366 && height === 625 ? 0.4 : share
/** Turned phones, 200 % and 400 % zoom: at least so high, in px. */
const low = [
  [844, 390],
  [683, 384],
  [320, 256],
] as const

const frame = '.space .frame'

test('the map has its share of every window, is 120 px high in the lowest, and nothing is out of reach', async ({
  child,
  page,
}) => {
  test.slow()
  const learner = new Learner(child)
  for (const card of Object.keys(shapes) as Card[]) {
    await page.setViewportSize({ width: 1366, height: 768 })
    await learner.opens(card)
    const map = async () => {
      const { width, height } = (await page.locator(frame).boundingBox())!
      const window = page.viewportSize()!
      return { height, share: (width * height) / (window.width * window.height) }
    }
    for (const [width, height] of [...large, ...low]) {
      await page.setViewportSize({ width, height })
      const where = `${card} at ${width} by ${height}`
      const least = height < 480 ? 0 : lessFor(card, width, height)
      await expect.poll(async () => (await map()).share, where).toBeGreaterThanOrEqual(least)
      await expect.poll(async () => (await map()).height, where).toBeGreaterThanOrEqual(120)
      // The buttons that play and guess can be scrolled into the window.
      for (const part of [
        child.button(height < 520 ? 'q.play' : 'lab.start').first(),
        child.button('q.guessing.open'),
        learner.timeline,
      ]) {
        await part.scrollIntoViewIfNeeded()
        await expect(part, where).toBeInViewport({ ratio: 0.99 })
      }
    }
  }
})

test('no text of the playground is smaller than 14 px, with the table and without', async ({
  child,
  page,
}) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  await child.presses('q.step')
  const small = () =>
    page.locator('.q').evaluate((playground) => {
      const found = new Set<string>()
      for (const element of playground.querySelectorAll<HTMLElement>('*')) {
        const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent!.trim())
        if (!own || element.closest('svg, .world, .for-ears-only') || !element.checkVisibility()) continue
        const size = Number.parseFloat(getComputedStyle(element).fontSize)
        if (size > 0 && size < 14) found.add(`${element.className} ${element.textContent.trim()} ${size}`)
      }
      return [...found]
    })
  for (const [width, height] of [
    [1366, 768],
    [1024, 600],
    [640, 480],
    [320, 256],
  ] as const) {
    // prettier-ignore
    await page.setViewportSize({ width, height })
    await expect.poll(small, `${width} by ${height}`).toEqual([])
  }
})

test('the table slides in beside the map where it has no place of its own, and out again', async ({
  child,
  page,
}) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  await expect(page.locator('.drawer .table')).toBeVisible()
  await page.setViewportSize({ width: 1024, height: 768 })
  await expect(page.locator('.drawer')).toHaveCount(0)
  const pages = page.getByRole('group', { name: child.word('q.pages'), exact: true })
  await pages.getByRole('button', { name: child.word('q.page.inside'), exact: true }).click()
  const [table, map] = [page.locator('.drawer'), page.locator(frame)]
  await expect(table).toBeInViewport({ ratio: 0.99 })
  await expect(map).toBeInViewport({ ratio: 0.99 })
  const edge = async () => {
    const [left, right] = [(await table.boundingBox())!, (await map.boundingBox())!]
    return right.x - (left.x + left.width)
  }
  await expect.poll(edge).toBeGreaterThan(0)
  await pages.getByRole('button', { name: child.word('q.page.map'), exact: true }).click()
  await expect(table).toHaveCount(0)
})

test('learning goes on while the program fills the page and the table is not displayed', async ({
  child,
  page,
}) => {
  const learner = new Learner(child)
  await learner.opens('railway')
  await learner.learns()
  await learner.unfolds()
  await child.presses('lab.fill', { pane: child.word('lab.program') })
  const table = page.locator('.drawer .table')
  await expect(table).toBeHidden()
  // The timeline is not displayed either.
  const made = async () => Number(await page.locator('.time input').getAttribute('max'))
  const before = await made()
  await expect.poll(made).toBeGreaterThan(before + 2)
  await child.presses('lab.shrink')
  await expect(table).toBeVisible()
})

test('the guess is a chip on the map that covers no station', async ({ child, page }) => {
  const learner = new Learner(child)
  for (const card of ['railway', 'city'] as const) {
    await page.setViewportSize({ width: 1366, height: 768 })
    await learner.opens(card)
    for (const [width, height] of [
      [1366, 768],
      [1024, 768],
      [1024, 600],
    ] as const) {
      // prettier-ignore
      await page.setViewportSize({ width, height })
      const chip = page.locator('.space .chip')
      await expect(chip).toBeVisible()
      const covered = () =>
        page.locator('.space [role=button] circle').evaluateAll((circles) =>
          circles
            .map((circle) => [circle, circle.getBoundingClientRect()] as const)
            .filter(
              ([circle, { x, y, width, height }]) =>
                circle.parentElement!.ariaLabel!.startsWith('Station') &&
                document.elementFromPoint(x + width / 2, y + height / 2)?.closest('.chip'),
            )
            .map(([circle]) => circle.parentElement!.ariaLabel),
        )
      await expect.poll(covered, `${card} at ${width} by ${height}`).toEqual([])
    }
  }
})
