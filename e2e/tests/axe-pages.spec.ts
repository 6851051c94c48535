// Rooms: projects, about, share, here, own-cards, materials, questionnaires, study, address, content
// axe in every state of the pages around the lab. Home: axe-home. Pages of a class: axe-class.
import { content } from '@botgarten/content/files'
import { sample } from '@botgarten/numbers/testing'
import { findsNothing, type States } from '../axe.ts'
import { opensSettings, option } from '../child-cards.ts'
import { CardMaker } from '../child-own-cards.ts'
import { ProjectList } from '../child-projects.ts'
import { Asker } from '../child-questionnaires.ts'
import { StudyHands } from '../child-study.ts'
import { Child } from '../child.ts'
import { serverWithData } from '../class-server.ts'
import { expect, test } from '../house.ts'
import { opensFromHome } from '../navigation.ts'
import { oneOfEachKind } from '../printed.ts'
import { freeProgram } from '../projects.ts'
import { givesVoice } from '../voice.ts'
import { languagesOf } from '../words.ts'

const projects: States = {
  'the menu of a project': async (child) => {
    await child.opensLab('friendship')
    await child.presses('lab.hint')
    await child.seesSaved()
    await new ProjectList(child).opens()
    await child.presses('projects.more', { name: child.card('friendship') })
  },
  'a project as a link': async (child) => {
    await child.presses('parts.share')
    await expect(child.page.getByRole('dialog')).toBeVisible()
  },
  'an empty bin': async (child) => {
    await new ProjectList(child).goesToBin()
    await expect(child.words('projects.binEmpty')).toBeVisible()
  },
  'the page about': async (child) => {
    await opensFromHome(child, 'parts.about')
    await expect(child.page.getByRole('heading', { level: 1 })).toHaveText(child.word('parts.about'))
  },
  'the machine that serves': async (child) => {
    // By address: the first start opens this page.
    await child.page.goto('/here')
    await expect(child.page.getByText(child.word('here.kept'))).toBeVisible()
  },
}

const listed: States = {
  'a new name': async (child) => {
    const list = new ProjectList(child)
    await list.opens()
    await list.opensFile(
      'Uno.json',
      freeProgram('Uno', (make) => [make.wait(1)]),
    )
    await expect(child.page.getByRole('heading', { level: 1 })).toHaveText('Uno')
    await child.seesSaved()
    await list.opens()
    await list.chooses('Uno', 'rename')
  },
  'into the bin': async (child) => {
    await child.presses('projects.cancel')
    await new ProjectList(child).chooses('Uno', 'throw')
    await new ProjectList(child).hears('projects.thrown', { name: 'Uno' })
  },
  'a full bin': (child) => new ProjectList(child).goesToBin(),
  'is it to be emptied?': (child) => child.presses('projects.emptyBin'),
  'a home file is read': async (child) => {
    await child.presses('projects.cancel')
    const list = new ProjectList(child)
    await list.opens()
    await list.opensFile('home.json', '{"botgartenHome":1,"projects":[{}]}')
    await expect(child.dialog('projects.mergedTitle')).toBeVisible()
  },
  'a link that is cut': async (child) => {
    // By address: a link that was cut.
    await child.page.goto('/open#v1.abc')
    await child.seesTitle()
  },
}

const cards: States = {
  'a card that is proved': async (child) => {
    const maker = new CardMaker(child)
    await maker.begins()
    await maker.writes()
    await maker.seesSolved(3, 3)
    await expect(child.words('cards.canShare')).toBeVisible()
  },
  'a card that is refused': async (child) => {
    await opensFromHome(child, 'home.materials')
    await child.page.getByRole('link', { name: child.word('parts.myCards'), exact: true }).click()
    const card = { text: { en: { title: '<script>', story: 'x', task: 'x', hints: ['x', 'x', 'x'] } } }
    const text = JSON.stringify({ botgarten: 'card', version: 1, card })
    await child.opensFileAtHome('card.botgarten.json', text)
    await expect(child.words('problem.notACard.title')).toBeVisible()
  },
}

const isReady = (child: Child) => expect(child.page.locator('.material[aria-busy="false"]')).toBeVisible()

async function opensItem(child: Child, item: string) {
  // By address: codes on paper and links of a plan lead to a page of its own.
  await child.page.goto(`/materials/${item}`)
}

/** An item of each kind. */
const kinds = [...new Set(content.items.map(({ kind }) => kind))].map((kind): States => {
  const [item] = sample(
    content.items.filter((one) => one.kind === kind),
    1,
  )
  return {
    [`${kind}: ${item!.id}`]: async (child) => {
      await opensItem(child, `${kind}/${item!.id}`)
      await isReady(child)
    },
  }
})

const library: States = {
  'all materials': async (child) => {
    await opensFromHome(child, 'home.materials')
    await expect(child.page.locator('.library li').first()).toBeVisible()
  },
  'nothing fits': async (child) => {
    await child.page.getByRole('searchbox').fill('Q1')
    await child.page.getByRole('checkbox', { name: child.word('materials.shelf.more') }).check()
    await expect(child.page.locator('.library li')).toHaveCount(0)
  },
  'an item beside the library': async (child) => {
    await child.presses('materials.takeAway')
    await child.page.getByRole('searchbox').fill('Q3')
    await child.presses('materials.look', { title: child.card('city') })
    await isReady(child)
  },
  'a set for a lesson': async (child) => {
    await child.page.getByRole('searchbox').fill('NN 5')
    await child.presses('materials.set.put', { title: child.card('friendship') })
    const mySet = child.page.getByRole('region', { name: child.word('materials.set.title') })
    await expect(mySet.getByRole('spinbutton').first()).toBeVisible()
  },
  'two hints of a card': async (child) => {
    await opensItem(child, 'card/friendship')
    await isReady(child)
    await child.presses('materials.askHint', { number: 1, of: 3 })
    await child.presses('materials.askHint', { number: 2, of: 3 })
  },
  'a question with its reason': async (child) => {
    await opensItem(child, 'questions/1')
    await isReady(child)
    await child.page.locator('.answers button').first().click()
    await expect(child.page.locator('.why')).not.toBeEmpty()
  },
  "the presenter's window": async (child) => {
    await opensItem(child, 'slides/teach-your-robot?presenter')
    const slide = (number: number) =>
      child.page.getByText(child.word('materials.slideOf', { number, of: 19 }), { exact: true })
    await expect(slide(1)).toBeVisible()
    await child.types('End')
    await expect(slide(19)).toBeVisible()
  },
  'a sheet in clear letters, read aloud, without Bo': async (child) => {
    await opensItem(child, 'worksheet/how-do-i-learn')
    await isReady(child)
    await opensSettings(child, 'home')
    for (const name of ['quiet', 'letters', 'aloud'] as const) await option(child, name).click()
    await child.types('Escape')
    const page = { what: child.word('materials.thePage') }
    await expect(child.button('comfort.read', page)).toBeVisible()
  },
}

/** Printed pages of each kind of item. */
const papers = [...oneOfEachKind, ['kit', 'sorting-game'] as const].map(([kind, id]): States => ({
  [`printed: ${kind} ${id}`]: async ({ page }) => {
    // By address: a window that is printed is opened by its address.
    await page.goto(`/materials/${kind}/${id}?paper=a4&address=https://botgarten.example.org/school`)
    await page.locator('html[data-print=ready]').waitFor({ state: 'attached' })
  },
}))

const asking: States = {
  'all questionnaires': (child) => new Asker(child).comes(),
  'a bird and a number': (child) => new Asker(child).asks('after', 5),
  'a screen of questions': (child) => child.presses('form.codeForgot'),
  ...Object.fromEntries(
    ['type', 'change', 'paper'].map((show) => [
      `a form, ${show}`,
      async (child: Child) => {
        // By address: each page as its link opens it.
        await child.page.goto(`/questionnaires?form=after&show=${show}`)
        await expect(child.page.getByRole('heading', { level: 1 }).first()).toBeVisible()
      },
    ]),
  ),
  'results of five': async (child) => {
    const asker = new Asker(child)
    await asker.comes()
    await asker.takesFile('after', 5, [0, 1, 2, 3, 4])
    await child.presses('form.close')
    await asker.opens('after', 'form.results')
    await expect(child.page.getByRole('row').first()).toBeVisible()
  },
  'one question with faces': async (child) => {
    const asker = new Asker(child)
    await asker.comes()
    await asker.asks('after', 3)
    await child.presses('form.codeForgot')
    await expect(child.words('form.questionOf', { number: 1, of: 13 })).toBeVisible()
  },
}

const studying: States = {
  'the page of study mode': (child) => new StudyHands(child).comes(),
  'a study is opened': async (child) => {
    await new StudyHands(child).opens()
    await expect(child.button('study.handOut')).toBeVisible()
  },
  'a number that is none': async (child) => {
    await child.page.getByLabel(child.word('study.consentBox')).check()
    await child.presses('study.handOut')
    await child.page.getByLabel(child.word('study.number')).fill('0102A')
    await child.presses('study.yes')
    await expect(child.words('study.wrongNumber')).toBeVisible()
  },
  'the parts of a study': (child) => new StudyHands(child).begins(1, 2),
  'a log is written': async (child) => {
    await new StudyHands(child).opensCard('friendship')
    await expect(child.words('study.writes')).toBeVisible()
  },
}

const planning: States = {
  'a study is planned': async (child) => {
    await new StudyHands(child).comes()
    await child.presses('study.make')
    await child.page.getByLabel(child.word('study.titleOf')).fill('Winter')
    await child.types('Tab', ...'Schnee')
    await child.button('study.saveFile').focus()
  },
  'slips with numbers': async (child) => {
    await child.presses('study.slips')
    await expect(child.page.getByText('0101D').first()).toBeVisible()
  },
}

const merged = (all: readonly States[]) => Object.assign({}, ...all) as States
const walks = { cards, library, kinds: merged(kinds), papers: merged(papers), asking, studying, planning }

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`pages around the lab, in ${language}`, () => {
    test.use({ language })
    for (const [name, states] of Object.entries(walks))
      test(`axe finds nothing: ${name}`, async ({ child, page }) => {
        test.setTimeout(240_000)
        if (name === 'library' || name === 'asking') await givesVoice(page, ['de-DE', 'en-GB'])
        await findsNothing(child, states)
      })
  })

  for (const [width, height] of [
    [1366, 768],
    [390, 844],
  ] as const)
    test.describe(`projects at ${width} × ${height}, in ${language}`, () => {
      test.use({ language, viewport: { width, height } })
      test('axe finds nothing on their pages', ({ child }) => findsNothing(child, projects))
    })
  for (const [width, height] of [
    [1024, 768],
    [390, 844],
  ] as const)
    test.describe(`what the pages about projects ask, at ${width} × ${height}, in ${language}`, () => {
      test.use({ language, viewport: { width, height } })
      test('axe finds nothing', ({ child }) => findsNothing(child, listed))
    })
}

test.describe('under an old address', () => {
  // Browsers resolve all names below localhost to this machine.
  test.use({ complaints: [/^A request to http:\/\/laptop\.localhost:\d+\//] })
  test('axe finds nothing in the way to the announced one', async ({ browser, contextOptions, locale }) => {
    const server = await serverWithData('http://garden.localhost:4173')
    const baseURL = `http://laptop.localhost:${server.port}`
    const context = await browser.newContext({ ...contextOptions, baseURL, locale })
    await findsNothing(new Child(await context.newPage(), 'en'), {
      'the way to the announced address': async (child) => {
        await child.page.goto('/')
        await expect(child.page.getByRole('dialog')).toContainText(child.word('address.nothing'))
      },
    })
    await context.close()
    await server.close()
  })
})
