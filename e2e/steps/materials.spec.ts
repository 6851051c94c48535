import type { Child } from '../child.ts'
import { MaterialHands } from '../child-materials.ts'
import { givesVoice } from '../voice.ts'
import { expect, follows, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

/** A device with a voice, on which texts can be read aloud. */
async function readsAloud({ page }: Child) {
  await givesVoice(page, ['en-GB'])
  await page.addInitScript(() => localStorage.setItem('botgarten.comfort', '{"aloud":true}'))
}

/** Shapes of small pictures with the marks on each: the tree does not list them. */
const thumbs = ({ page }: Child) =>
  page.locator('.library .thumb').evaluateAll((all) => {
    const marks = [
      '.bar svg',
      '.line',
      '.paper > .bo',
      'img[src]',
      '.cut svg',
      '.table',
      '.ticks svg',
      '.lines i',
      '.lines b',
    ]
    const shapeOf = (one: Element) =>
      ['card', 'slides', 'kit', 'sheet'].find((name) => one.classList.contains(name))
    const drawn = all.map((one) =>
      [shapeOf(one), ...marks.map((mark) => `${mark} ${one.querySelectorAll(mark).length}`)]
        .filter((mark) => !mark?.endsWith(' 0'))
        .join(', '),
    )
    return [...new Set(drawn)].toSorted()
  })

test('the library of materials, step by step', { tag: '@materials' }, async ({ child, page }) => {
  const hands = new MaterialHands(child)
  const ticks = (key: string) => page.getByRole('checkbox', { name: child.word(key), exact: true }).click()
  const chooses = (key: string, value: string) =>
    page.getByRole('combobox', { name: child.word(key) }).selectOption(value)
  const folds = (key: string) => page.locator('summary', { hasText: child.word(key) }).click()
  const takesAway = async () => {
    await child.presses('materials.takeAway')
    await expect(page.getByRole('searchbox')).toBeFocused()
    await hands.finds('fear')
  }
  const looks = (title: string) => child.presses('materials.look', { title })
  const puts = (title: string) => child.presses('materials.set.put', { title })
  const fear = child.card('fear')
  const mySet = page.getByRole('region', { name: child.word('materials.set.title') })
  /** Presses a button `times` times at once. */
  const clicks = (key: string, times: number) =>
    child.button(key).evaluate((button: HTMLElement, times) => {
      for (let left = times; left > 0; left -= 1) button.click()
    }, times)
  const printed = () => expect(page.locator('html[data-print=ready] .pack')).toBeVisible()
  const preview = (parts: string) => expect(page.locator(`.preview ${parts}`)).toHaveCount(2)
  await goesThrough(child, 'materials-library', {
    async 'words of titles are found'() {
      await follows(child, 'home.materials')
      await expect
        .poll(() => thumbs(child))
        .toEqual([
          'card, .bar svg 1, .paper > .bo 1, .lines i 3',
          'card, .bar svg 1, img[src] 1, .lines i 3',
          'kit, .line 1, .cut svg 6',
          'sheet, .line 1, .lines i 3, .lines b 3',
          'sheet, .line 1, .table 1',
          'sheet, .line 1, .ticks svg 4',
          'slides, .line 1, img[src] 1, .lines i 2',
        ])
      await hands.finds('fear')
      await expect(page.locator('.filters small').first()).toHaveText('2')
    },
    'words on a slide are found': () => hands.finds('rats'),
    'words of a heading are found': () => hands.finds('games learn'),
    'nothing is found': () => hands.finds('games xyz'),
    'everything is shown again': takesAway,
    async 'a time and a grade are chosen'() {
      await chooses('materials.time', '45')
      await chooses('materials.grade', '4')
    },
    'any time will do': () => chooses('materials.time', ''),
    'the choice is taken away': takesAway,
    async 'a module and a kind are ticked'() {
      await ticks('materials.moduleName.2')
      await ticks('materials.shelf.cards')
    },
    'the modules are folded': () => folds('materials.modules'),
    async 'both folds are opened'() {
      await folds('materials.wayOfLearning')
      await folds('materials.together')
    },
    async 'a way and a number are ticked'() {
      await ticks('materials.wayName.supervised')
      await ticks('materials.social.pairs')
    },
    'nothing for teachers': () => ticks('materials.forTeachers'),
    async 'the module is ticked no longer'() {
      await folds('materials.modules')
      await ticks('materials.moduleName.2')
    },
    'all of it is taken away': takesAway,
    async 'a card is looked at'() {
      await looks(fear)
      await preview('.side')
    },
    'the card is put into the set': () => puts(fear),
    'the card is looked at no longer': () => looks(fear),
    async 'slides are looked at'() {
      await hands.finds('Slides')
      await looks('Four brains')
      await preview('.slide')
    },
    'the slides are closed': () => child.presses('parts.close'),
    async 'the set is named and counted'() {
      await mySet.getByRole('textbox').fill('Ours')
      await mySet.getByRole('textbox').blur()
      await child.presses('materials.set.fewer')
      await child.presses('materials.set.fewer')
      await child.presses('materials.set.more')
    },
    async 'the card is printed twice'() {
      await mySet.getByRole('spinbutton').fill('2')
      await mySet.getByRole('spinbutton').blur()
    },
    'both languages': () => mySet.getByRole('button', { name: 'Deutsch + English' }).click(),
    'one card on A5': () => child.presses('materials.printA5'),
    'two cards on A4': () => child.presses('materials.printTwoUp'),
    'two sets': () => child.presses('materials.set.moreSets'),
    'as many sets as there may be': () => clicks('materials.set.moreSets', 18),
    'one set fewer': () => child.presses('materials.set.fewerSets'),
    'as many children as there may be': () => clicks('materials.set.more', 76),
    'on a grey printer': () => mySet.getByRole('switch').click(),
    async 'the set is printed'() {
      await hands.link('materials.print').click()
      await printed()
    },
    async 'it is printed for fewer, in colour and one language'() {
      // By address: a link to a set with its numbers.
      await page.goto('/materials/pack/my-set?children=1&sets=20')
      await printed()
    },
    async 'the set is empty'() {
      await hands.link('materials.all').click()
      await hands.finds('fear')
      await child.presses('materials.set.clear')
    },
    async 'a plan is looked at on a small screen'() {
      await page.setViewportSize({ width: 1100, height: 768 })
      await hands.finds('P 3')
      await looks('Friendship and Fear')
    },
    'all that it needs is in the set': () => child.presses('materials.set.takeAll'),
    'the dialog is closed': () =>
      page
        .getByRole('dialog')
        .getByRole('button', { name: child.word('parts.close') })
        .click(),
    'it is opened again, and closed by its key': async () => {
      await looks('Friendship and Fear')
      await expect(page.getByRole('dialog')).toBeVisible()
      await child.types('Escape')
      await page.setViewportSize({ width: 1366, height: 768 })
      await hands.finds('fear')
    },
  })
})

/** Items with the embeds that their names mention. */
const documents = {
  'a card with Bo and a code': 'card/meet-bo',
  'a sheet with three drawings': 'worksheet/three-ways',
  'a sheet of a program': 'sheet/q-program',
  'a flow diagram': 'sheet/q-flow',
  'things to cut out': 'kit/sorting-cards',
  'cages to fill in': 'worksheet/zoo-sheet',
  'cages with their answers': 'solution/solutions-zoo',
  'senses to fill in': 'worksheet/loophole-zoo',
  'senses with their answers': 'solution/solutions-senses',
  'animals on a poster': 'worksheet/loophole-poster',
  'answers to questions': 'solution/solutions-questions',
  'things to read on': 'links/further-material',
  'what modules cover': 'links/alignment-table',
  'a plan with a picture': 'plan/friendship-and-fear',
  'a plan of many copies': 'plan/how-does-bo-learn',
  'a plan of a single lesson': 'plan/lesson-own-map',
} as const

/** Cards, whose backs differ. */
const cards = {
  'a card of blocks': 'card/tidy-up',
  'a card of three runs': 'card/q-railway',
  'a card of five runs': 'card/q-forest',
  'a card without runs': 'card/q-cheating',
} as const

const opensAll = (hands: MaterialHands, places: Readonly<Record<string, string>>) =>
  Object.fromEntries(Object.entries(places).map(([name, place]) => [name, () => hands.opens(place)]))

test('cards of the materials, step by step', { tag: '@materials' }, async ({ child, page }) => {
  const hands = new MaterialHands(child)
  const { hint, askHint } = { hint: 'comfort.theHint', askHint: 'materials.askHint' }
  await readsAloud(child)
  await goesThrough(child, 'materials-cards', {
    async 'a card with its hints'() {
      await follows(child, 'home.materials')
      await hands.opens('card/friendship')
      expect(await hands.reads('comfort.theCard')).toContain(child.card('friendship'))
    },
    async 'a hint is asked for'() {
      await child.presses(askHint, { number: 1, of: 3 })
      expect(await hands.reads(hint)).toBeTruthy()
      await expect(page.locator('.hints > li:visible')).toHaveCount(1)
    },
    async 'all hints are there'() {
      await child.presses(askHint, { number: 2, of: 3 })
      await child.presses(askHint, { number: 3, of: 3 })
    },
    ...opensAll(hands, cards),
  })
})

test('documents of the materials, step by step', { tag: '@materials' }, async ({ child, page }) => {
  const hands = new MaterialHands(child)
  await readsAloud(child)
  await goesThrough(child, 'materials-documents', {
    async 'roles of a pair'() {
      await follows(child, 'home.materials')
      await hands.opens('worksheet/pair-roles')
      expect(await hands.reads('materials.thePage')).toMatch(/^Hand and Eye/)
    },
    ...opensAll(hands, documents),
    async 'a clock is over'() {
      await hands.opens('worksheet/pair-roles')
      await page.clock.install()
      await child.presses('materials.startTimer')
      await page.clock.fastForward('10:00')
    },
    async 'the time begins again'() {
      await page.clock.pauseAt(Date.now() + 3_600_000)
      await child.presses('materials.againTimer')
    },
  })
})

test('slides of the materials, step by step', { tag: '@materials' }, async ({ child, page, context }) => {
  const hands = new MaterialHands(child)
  await readsAloud(child)
  const shows = (number: number, of: number) =>
    expect(page.getByText(child.word('materials.slideOf', { number, of }), { exact: true })).toBeVisible()
  const presenter = async () => {
    const [opened] = await Promise.all([context.waitForEvent('page'), child.presses('materials.presenter')])
    expect(opened.url()).toContain('/materials/slides/slides-four-brains?presenter')
    await opened.close()
  }
  /** The page in a frame on a slide is not loaded here. */
  const framed = (address: string) =>
    expect(page.locator('iframe')).toHaveAttribute('src', new RegExp(address))
  await page.route(/\/(lab|race|sorting)\b/, (route) =>
    route.request().resourceType() === 'document' && route.request().frame() !== page.mainFrame()
      ? route.fulfill({ contentType: 'text/html', body: '' })
      : route.continue(),
  )
  await goesThrough(child, 'materials-slides', {
    async 'all slides of a deck'() {
      await follows(child, 'home.materials')
      await hands.opens('slides/slides-four-brains')
      expect(await hands.reads('materials.theSlide', { number: 2 })).toBeTruthy()
      await presenter()
    },
    async 'they are shown'() {
      await child.presses('materials.present')
      expect(await hands.reads('materials.theSlide', { number: 1 })).toBeTruthy()
      await presenter()
    },
    async 'a key turns them'() {
      await child.types('ArrowRight')
      await shows(2, 9)
    },
    'a button turns to a lab': async () => {
      await child.presses('materials.slideNext')
      await child.presses('materials.slideNext')
      await framed('/lab/four-brains\\?p=')
    },
    'a button turns back': () => child.presses('materials.slideBefore'),
    async 'a finger turns back and on'() {
      const swipe = (from: number, to: number) =>
        page.locator('.stage').evaluate(
          (stage, [from, to]) => {
            for (const [type, clientX] of [
              ['pointerdown', from],
              ['pointerup', to],
            ] as const)
              stage.dispatchEvent(
                new PointerEvent(type, { pointerId: 1, pointerType: 'touch', clientX, bubbles: true }),
              )
          },
          [from, to] as const,
        )
      await swipe(100, 300)
      await shows(2, 9)
      await swipe(300, 100)
      await shows(3, 9)
      await swipe(300, 100)
      await shows(4, 9)
      await child.presses('materials.fullScreen')
      const isFull = () => page.evaluate(() => document.fullscreenElement !== null)
      await expect.poll(isFull).toBe(true)
      await child.types('f')
      await expect.poll(isFull).toBe(false)
    },
    async 'the last slide'() {
      await child.types('End')
      await shows(9, 9)
    },
    'all slides are there again': () => child.presses('materials.endShow'),
    async 'a slide with a race is shown'() {
      await child.presses('materials.showSlide', { number: 6 })
      await framed('/race\\?brains=garden')
    },
    'the show is ended by its key': () => child.types('Escape'),
    async 'slides with blocks and tables'() {
      await page.evaluate(() => Object.assign(window, { print: () => undefined }))
      await hands.opens('slides/learn-from-experience')
      await child.presses('materials.printNotes')
      await expect(page.locator('.with-notes').first()).toBeAttached()
      await page.evaluate(() => dispatchEvent(new Event('afterprint')))
      await expect(page.locator('.with-notes')).toHaveCount(0)
    },
    async 'questions on a slide'() {
      await child.presses('materials.showSlide', { number: 18 })
      await hands.seesDrawn()
      expect(await hands.reads('materials.theQuestion')).toBeTruthy()
    },
    async 'the class answers'() {
      await page.locator('.answers button').first().click()
      await hands.seesDrawn()
      expect(await hands.reads('materials.theWhy')).toBeTruthy()
    },
    async 'a cage is asked about'() {
      await child.presses('materials.next')
      await page.locator('.answers button').first().click()
      await child.presses('materials.next')
      await hands.seesDrawn()
    },
    async 'slides with animals and a clock'() {
      await child.types('Escape')
      await hands.opens('slides/slides-nobody-tells')
    },
    'slides with things to sort': () => hands.opens('slides/can-robots-learn-alone'),
    async 'sorting on a slide'() {
      await child.presses('materials.showSlide', { number: 10 })
      await framed('/sorting')
    },
  })
})

test(
  'what a teacher sees in a window of its own, step by step',
  { tag: '@materials' },
  async ({ child, page }) => {
    // By address: a press opens this in another window.
    await page.goto('/materials/slides/slides-four-brains?presenter')
    const steps = {
      'the first slide and the next': () => expect(page.locator('.presenter')).toBeVisible(),
      'a button turns on': () => child.presses('materials.slideNext'),
      'a key turns on': () => child.types('ArrowRight'),
      'a button turns back': () => child.presses('materials.slideBefore'),
      'the last slide': () => child.types('End'),
    }
    await goesThrough(child, 'materials-presenter', steps, { hides: /\b\d+:\d\d\b|\b[AP]M\b/g })
  },
)

test('what will Bo do, step by step', { tag: '@materials' }, async ({ child, page }) => {
  const hands = new MaterialHands(child)
  const answers = async (at: number) => {
    await page.locator('.answers > button').nth(at).click()
    await hands.seesDrawn()
  }
  const answersOn = async (...all: readonly number[]) => {
    for (const at of all) {
      await child.presses('materials.next')
      await answers(at)
    }
  }
  const module = (number: number) => page.locator(`nav a[href$="/questions/${number}"]`).click()
  await goesThrough(child, 'materials-questions', {
    async 'questions of sorting'() {
      await follows(child, 'home.materials')
      await module(4)
      await hands.seesDrawn()
    },
    'the right answer': () => answers(0),
    async 'a wrong one'() {
      await child.presses('materials.next')
      await answers(0)
    },
    'the question before': () => child.presses('materials.before'),
    async 'all are answered before the module'() {
      await child.presses('materials.next')
      await answersOn(0, 0)
    },
    'after the module': () => child.presses('materials.phase.after'),
    async 'all are answered after it'() {
      await answers(0)
      await answersOn(1, 0, 1)
    },
    'once more': () => child.presses('materials.askAgain'),
    async 'what is answered is told with all materials'() {
      await hands.link('materials.all').click()
      await hands.finds('fear')
    },
    async 'a question about a ride'() {
      await module(1)
      await hands.seesDrawn()
    },
    'what the ride shows': () => answers(1),
    async 'a question about a lamp'() {
      await hands.link('materials.all').click()
      await hands.finds('fear')
      await module(2)
      await answers(0)
      await answersOn(0)
      await child.presses('materials.next')
      await hands.seesDrawn()
    },
    'what the lamp shows': () => answers(0),
    async 'a question about a way'() {
      await hands.link('materials.all').click()
      await hands.finds('fear')
      await module(3)
      await hands.seesDrawn()
    },
    'what the way shows': () => answers(0),
  })
})

/** Hands for pages that are laid out as paper. */
function paperHands(child: Child) {
  const { page } = child
  const hands = new MaterialHands(child)
  /** Waits for the mark that a page sets when it is ready for print. */
  const prints = async (chooses: () => Promise<unknown>) => {
    await page.evaluate(() => delete document.documentElement.dataset['print'])
    await chooses()
    await expect(page.locator('html[data-print=ready]')).toBeAttached()
    await hands.seesDrawn()
  }
  const follow = (key: string) => prints(() => hands.link(key).first().click())
  const onPaper = async (place: string) => {
    await follows(child, 'home.materials')
    await hands.opens(place)
    await follow('materials.onPaper')
  }
  const asked = () => page.evaluate(() => (globalThis as unknown as { asked: number }).asked)
  const pressesPrint = async () => {
    await page.evaluate(() =>
      Object.assign(window, {
        asked: 0,
        print: () => ((globalThis as unknown as { asked: number }).asked += 1),
      }),
    )
    await child.presses('materials.print')
    await expect.poll(asked).toBe(1)
  }
  const pack = (place: string, of: string) => prints(() => page.goto(`/materials/pack/${place}?${of}`))
  return { hands, prints, follow, onPaper, pressesPrint, pack }
}

test('materials on paper, step by step', { tag: '@materials' }, async ({ child, page }) => {
  const { prints, follow, onPaper, pressesPrint } = paperHands(child)
  await goesThrough(child, 'materials-paper', {
    async 'a card on paper'() {
      await onPaper('card/meet-bo')
      await pressesPrint()
    },
    'it is printed grey': () => follow('materials.grey'),
    'it turns over the long edge': () => follow('materials.turnLong'),
    'it turns over the short edge': () => follow('materials.turnShort'),
    'it is one card on A5': () => follow('materials.printA5'),
    'it is two cards on A4 again': () => follow('materials.printTwoUp'),
    'it is in colour again': () => follow('materials.grey'),
    'its code is on paper': () => page.emulateMedia({ media: 'print' }),
    async 'a set of cards on paper'() {
      await page.emulateMedia({ media: 'screen' })
      await onPaper('card/sorting-cards-lab')
    },
    async 'a sheet on paper'() {
      await onPaper('sheet/q-program')
    },
    async 'a deck on paper'() {
      await onPaper('slides/slides-four-brains')
      const poses = page
        .locator('.slide.words')
        .evaluateAll((all) => all.map((one) => one.querySelector('svg')?.getAttribute('height')))
      expect((await poses).length).toBeGreaterThan(2)
    },
    async 'a plan on paper'() {
      await onPaper('plan/friendship-and-fear')
    },
    async 'paper without addresses'() {
      // By address: a script prints like this.
      await prints(() => page.goto('/materials/plan/friendship-and-fear?paper=a4&address='))
    },
    async 'a code without an address'() {
      await prints(() => page.goto('/materials/card/meet-bo?paper=a5&address='))
      await page.emulateMedia({ media: 'print' })
    },
  })
})

test('packs on paper, step by step', { tag: '@materials' }, async ({ child, page }) => {
  const { hands, prints, follow, pressesPrint, pack } = paperHands(child)
  await goesThrough(child, 'materials-packs', {
    async 'a pack of a lesson'() {
      await follows(child, 'home.materials')
      await expect(page.locator('.library li').first()).toBeVisible()
      await pack('friendship-and-fear', 'children=2')
      await pressesPrint()
    },
    'its sheets are for the youngest': () =>
      prints(() =>
        page.getByRole('link', { name: child.word('materials.grades', { from: 3, to: 4 }) }).click(),
      ),
    'only the answers': () => pack('teach-bo', 'answers=only'),
    'a pack in both languages': () => pack('lesson-own-map', 'languages=de,en&children=2&answers=apart'),
    'a pack in one language': () => pack('lesson-own-map', 'children=2'),
    'one child fewer': () => follow('materials.set.fewer'),
    'two sets': () => follow('materials.set.moreSets'),
    async 'one child more, a set fewer'() {
      await follow('materials.set.more')
      await follow('materials.set.fewerSets')
    },
    async 'it is grey, for one card on A5'() {
      await follow('materials.grey')
      await follow('materials.printA5')
    },
    'its cards turn over the long edge': () => follow('materials.turnLong'),
    async 'all of it is in the set'() {
      await child.presses('materials.set.takeAll')
      await hands.link('materials.all').click()
      await hands.finds('fear')
    },
  })
})
