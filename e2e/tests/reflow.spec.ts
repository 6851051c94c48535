// Rooms: words, parts
import { opensSettings } from '../child-cards.ts'
import { ProjectList } from '../child-projects.ts'
import { SortingHands } from '../child-sorting.ts'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'
import { outOfReach } from '../reach.ts'
import { languages } from '../words.ts'

/** WCAG 1.4.10: 1280 px at 400 %; a school laptop of 1366 × 768 at the same; a phone, a tablet both ways, and that laptop. */
const sizes = [
  { width: 320, height: 256 },
  { width: 342, height: 192 },
  { width: 390, height: 844 },
  { width: 768, height: 1024 },
  { width: 1024, height: 768 },
  { width: 1366, height: 768 },
]

type Faces = { readonly [name: string]: (child: Child) => Promise<unknown> }

const goes = (path: string) => async (child: Child) => {
  // By address: links and printed codes lead there.
  await child.page.goto(path)
  await expect(child.page.locator('main')).toHaveCount(1)
  await expect(child.page.locator('.material[aria-busy="true"]')).toHaveCount(0)
}

/** One page load each. */
const pages: Faces = {
  home: (child) => child.opensHome(),
  sorting: (child) => new SortingHands(child).opens(),
  about: (child) => opensFromHome(child, 'parts.about'),
  'a link that is cut': goes('/open#v1.abc'),
  'all materials': (child) => opensFromHome(child, 'home.materials'),
  cards: goes('/materials/card/network-cards'),
  'a worksheet': goes('/materials/worksheet/how-do-i-learn'),
  'questions of a module': goes('/materials/questions/1'),
  'all slides': goes('/materials/slides/can-robots-learn-alone'),
  'study mode': goes('/study'),
  questionnaires: goes('/questionnaires'),
  'results of a questionnaire': goes('/questionnaires?form=after&show=results'),
  'a questionnaire on one device': goes('/questionnaires?form=after&show=ask'),
  'counts from paper': goes('/questionnaires?form=after&show=type'),
  'a questionnaire that is changed': goes('/questionnaires?form=after&show=change'),
  'a slide': goes('/materials/slides/can-robots-learn-alone?slide=3'),
}

/** The lab without loading it again, with what opens over it. */
const lab: Faces = {
  world: (child) => child.opensLab('friendship'),
  program: async (child) => {
    await child.turnsTo('program')
    await child.seesBlocks()
  },
  network: (child) => child.turnsTo('networkTab'),
  'settings of the network': (child) => child.presses('network.settings'),
  hint: async (child) => {
    await child.types('Escape')
    await child.presses('lab.hint')
    await expect(child.page.getByRole('region', { name: child.word('lab.hint') })).toBeVisible()
  },
  menu: async (child) => {
    await child.presses('parts.close')
    await child.presses('lab.menu')
    await expect(child.button('lab.saveFile')).toBeVisible()
  },
  settings: async (child) => {
    await child.types('Escape')
    await opensSettings(child, 'lab')
  },
  card: async (child) => {
    await child.presses('parts.close')
    await child.presses('lab.card')
    await expect(child.page.getByRole('dialog')).toBeVisible()
  },
  'learning by trying': async (child) => {
    await child.opensLab('railway')
    await child.page
      .getByRole('navigation', { name: child.word('lab.panes') })
      .getByRole('button', { name: child.word('lab.learningTab'), exact: true })
      .click()
    await expect(child.button('q.turbo')).toBeVisible()
  },
  'my projects': async (child) => {
    await new ProjectList(child).opens()
    await expect(child.page.getByRole('article').first()).toBeVisible()
  },
  'the bin': (child) => new ProjectList(child).goesToBin(),
}

for (const language of languages)
  test.describe(`at every width and at 400 % zoom, in ${language}`, () => {
    test.use({ language, viewport: sizes[0]!, contextOptions: { reducedMotion: 'reduce' } })

    for (const [what, faces] of Object.entries({ pages, lab }))
      test(`everything can be reached, nothing lies on anything else: ${what}`, async ({ child, page }) => {
        const found: { [face: string]: string[] } = {}
        for (const [face, show] of Object.entries(faces))
          await test.step(face, async () => {
            await show(child)
            await page.evaluate(() => document.fonts.ready)
            for (const size of sizes) {
              const name = `${face}, ${size.width} × ${size.height}`
              await page.setViewportSize(size)
              await child.watches(3)
              const faults = await outOfReach(page)
              if (faults.length > 0) found[name] = faults
            }
            await page.setViewportSize(sizes[0]!)
          })
        expect(found).toEqual({})
      })
  })
