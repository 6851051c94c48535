import { expect, type Locator } from '@playwright/test'
import type { Child } from './child.ts'
import { bedOf, chapterOf } from './words.ts'

/** The three beds of cards: on the home page alone. */
export const bedsOf = (child: Child): Locator =>
  child.page.getByRole('region', { name: child.word('home.beds'), exact: true })

/** Closes a dialog in front of the page, as a child does before pressing a button behind it. */
export async function closesDialog({ page }: Child) {
  const dialog = page.locator('dialog:modal')
  if ((await dialog.count()) === 0) return
  await page.keyboard.press('Escape')
  await expect(dialog).toHaveCount(0)
}

/** Goes to the home page by the link that every page has; a browser with an empty page opens its address. */
export async function goesHome(child: Child) {
  const { page } = child
  await closesDialog(child)
  const beds = bedsOf(child)
  const home = page.locator('a[href$="/"]:visible').first()
  // Tests do not need the pictures, which load last.
  if (page.url() === 'about:blank') await page.goto('/', { waitUntil: 'commit' })
  // A page that is still loading shows neither; the home page has no link to itself.
  await expect(beds.or(home).first()).toBeVisible()
  if (!(await beds.isVisible())) await child.press(home)
  await expect(beds).toBeVisible()
}

const chapters = { examples: 'home.fromExamples', trying: 'home.byTrying' } as const

/** The link to a card on the home page; the chapter that contains it is opened. */
export async function findsCard(child: Child, card: string): Promise<Locator> {
  const chapter = chapterOf(card)
  const link = child.page.locator(`a[href$="/lab/${card}"]`).first()
  // Only this bed has chapters. The one that was open last stays open.
  if (bedOf(card) === 'network' && !(await link.isVisible()))
    await child.presses(chapter ? chapters[chapter] : 'home.byHand')
  return link
}

/** Opens a card from the home page. */
export async function opensCard(child: Child, card: string) {
  await goesHome(child)
  await child.press(await findsCard(child, card))
}

/** Opens the free lab from the home page of a device without projects: Bo drives at once, and is put back to its start. */
export async function opensFreeLab(child: Child) {
  await goesHome(child)
  await child.press(child.page.getByRole('link', { name: child.word('home.drive') }))
  await child.pressesStop()
  await child.presses('lab.resetWorld')
}

/** A page that the home page leads to, by the words of its link. */
export async function opensFromHome(child: Child, key: string) {
  await goesHome(child)
  await child.press(child.page.getByRole('link', { name: child.word(key), exact: true }))
}

/**
 * From now on this device draws 0 whenever it needs one random number: its dice are those of a link with `?dice=1`, and
 * learning has the same result in every run.
 */
export async function fixesDice({ page }: Child) {
  const fix = () => {
    const draw = crypto.getRandomValues.bind(crypto)
    crypto.getRandomValues = <T extends ArrayBufferView | null>(numbers: T): T => {
      if (!(numbers instanceof Uint32Array) || numbers.length > 1)
        return draw(numbers as Uint32Array<ArrayBuffer>) as unknown as T
      numbers.fill(0)
      return numbers
    }
  }
  await page.addInitScript(fix)
  await page.evaluate(fix)
}
