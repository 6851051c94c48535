// Rooms: editor, words
import { tableOf } from '@botgarten/messages/folder'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'

const read = (language: string) => tableOf('blockly', language) as Record<string, string>
const [english, german] = [read('en'), read('de')]

const escape = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')

/** English sentences of Blockly's that are other ones in German, as patterns with gaps for what is put in. */
const patterns = Object.entries(english)
  .filter(([key, text]) => text !== german[key] && /[a-z]{4}/i.test(text))
  .map(([, text]) => new RegExp(`^${text.split(/%\d+/).map(escape).join('.*')}$`))

const isEnglish = (text: string) =>
  [text, ...text.split(/, |: |\. /)].some((part) => patterns.some((pattern) => pattern.test(part.trim())))

/** Everything in the editor that is read or heard: words, labels, kinds of things, tooltips. */
const said = (child: Child) =>
  child.page.evaluate(() => {
    const places = '.injectionDiv, .blocklyWidgetDiv, .blocklyDropDownDiv, .blocklyToast, #hiddenForAria'
    const names = ['aria-label', 'aria-roledescription', 'aria-valuetext', 'title', 'placeholder']
    const things = [...document.querySelectorAll(places)].flatMap((place) => [
      place,
      ...place.querySelectorAll('*'),
    ])
    const leaves = things
      .filter(({ children }) => children.length === 0)
      .map(({ textContent }) => textContent ?? '')
    const labels = things.flatMap((thing) => names.map((name) => thing.getAttribute(name) ?? ''))
    return [...new Set([...leaves, ...labels].map((text) => text.replaceAll('\u00a0', ' ').trim()))].filter(
      Boolean,
    )
  })

async function hearsNoEnglish(child: Child) {
  const all = await said(child)
  expect(all.length).toBeGreaterThan(20)
  expect(all.filter(isEnglish)).toEqual([])
}

const menu = (child: Child) => child.page.locator('.blocklyContextMenu')
/** Somewhere on the network block where nothing else lies. */
const head = { position: { x: 40, y: 12 } }

for (const way of ['from the start', 'after a change in place'] as const)
  test.describe(`Blockly in German ${way}`, () => {
    test.use({ language: way === 'from the start' ? 'de' : 'en' })
    test.beforeEach(async ({ child }) => {
      await child.opensLab('friendship')
      if (way !== 'from the start') await child.speaks('de')
      await expect(child.page.getByRole('figure', { name: '1 Stapel mit Blöcken' })).toBeAttached()
    })

    test('says no English word in blocks, shelf, menus and hints', async ({ child }) => {
      await hearsNoEnglish(child)
      await child.block('net').click({ ...head, button: 'right' })
      await expect(menu(child)).toContainText('Verdoppeln')
      await expect(menu(child)).toContainText('Blöcke löschen')
      await hearsNoEnglish(child)
      await child.types('Escape')

      await child.page.mouse.click(400, 640, { button: 'right' })
      await expect(menu(child)).toContainText('Blöcke aufräumen')
      await child.types('Escape')

      for (const category of ['action', 'network']) {
        await child.page.getByRole('treeitem', { name: child.word(`category.${category}`) }).click()
        await hearsNoEnglish(child)
      }
      await child.types('Escape')
    })

    test('says no English word to who works by keyboard', async ({ child }) => {
      await child.block('net').click(head)
      for (const key of ['ArrowRight', 'ArrowLeft', 'i', 'Shift+I', 'm', 'ArrowDown', 'Escape', '/']) {
        await child.types(key)
        await hearsNoEnglish(child)
      }
      await child.block('net').click(head)
      await child.types('Control+c')
      await expect(child.page.locator('.blocklyToast')).toHaveText('Kopiert. Einfügen: Strg + V.')
      await hearsNoEnglish(child)
    })
  })

test('the test itself knows English when it sees it', async ({ child }) => {
  await child.opensLab('friendship')
  await child.block('net').click({ ...head, button: 'right' })
  await expect(menu(child)).toContainText('Duplicate')
  await expect.poll(async () => (await said(child)).filter(isEnglish).length).toBeGreaterThan(3)
})
