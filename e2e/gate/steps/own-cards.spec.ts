import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { CardMaker } from '../../child-own-cards.ts'
import { expect, follows, link, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

const solution = () => {
  const { card, world } = content.card('friendship')!
  return JSON.stringify(cardProject(world, card, content.program('friendship', 'solution')!, 'Other'))
}

test('a card is made, step by step', { tag: ['@own-cards', '@materials'] }, async ({ child, page }) => {
  const maker = new CardMaker(child)
  const named = (role: 'combobox' | 'spinbutton' | 'checkbox', key: string) =>
    page.getByRole(role, { name: child.word(key), exact: true })
  const place = (number: number, key: string) =>
    page.getByRole('spinbutton', {
      name: `${child.word('cards.place', { number })}: ${child.word(key)}`,
      exact: true,
    })
  const types = async (field: ReturnType<typeof named>, text: string) => {
    await field.fill(text)
    await field.blur()
  }
  /** Bo has tried the card, as it is now, from every place. */
  const tried = async () => {
    await child.watches(5)
    await expect(page.getByText(child.word('cards.trying'))).toHaveCount(0)
    await child.seesSaved()
  }
  const after = (act: () => Promise<unknown>) => async () => {
    await act()
    await tried()
  }
  const adds = (kind: string) => named('combobox', 'cards.addCheck').selectOption(kind)
  const begins = (option: number | string) =>
    named('combobox', 'cards.start').selectOption(
      typeof option === 'string' ? { label: option } : { index: option },
    )
  const addsWrong = (label: string) => named('combobox', 'cards.addWrong').selectOption({ label })
  const removes = (key: string) =>
    page
      .getByRole('button', { name: new RegExp(`^${child.word(key, { goal: '.*', name: '.*' })}$`) })
      .last()
      .click()
  const saves = async (key: string) => {
    const [file] = await Promise.all([page.waitForEvent('download'), child.presses(key)])
    expect(file.suggestedFilename()).toContain(maker.title)
  }
  const other = child.word('cards.startFrom', { name: 'Other' })
  await goesThrough(
    child,
    'own-cards',
    {
      async 'no card is here'() {
        await follows(child, 'home.materials')
        await link(child, 'parts.myCards').click()
      },
      'a file is refused': () =>
        child.opensFileAtHome('card.botgarten.json', '{"botgarten":"card","version":1}'),
      async 'a card is begun'() {
        await child.opensProjectAtHome('Other', solution())
        await maker.begins()
        await tried()
      },
      async 'its words are written'() {
        await maker.writes()
        await maker.seesSolved(3, 3)
        await tried()
      },
      async 'its words in German'() {
        await child.presses('cards.inGerman')
        await maker.field('cards.cardTitle').fill('Quadrat')
      },
      'its words in English': () =>
        page
          .getByRole('group', { name: child.word('cards.words') })
          .getByRole('button', { name: child.word('cards.inEnglish') })
          .click(),
      async 'its grades and minutes'() {
        await types(named('spinbutton', 'cards.from'), '4')
        await types(named('spinbutton', 'cards.to'), '99')
        await types(named('spinbutton', 'cards.minutes'), '99')
      },
      'a place is moved by keys': after(async () => {
        await child.button('cards.place', { number: 1 }).focus()
        await child.types('ArrowRight', 'ArrowUp', ',')
      }),
      'a place is moved by hand': after(async () => {
        const from = await child.middleOf(child.button('cards.place', { number: 2 }))
        await child.drags(from, { x: from.x + 10, y: from.y })
      }),
      'a place is moved by its number': after(() => types(place(3, 'cards.turned'), '95')),
      'another place is in hand': () => place(1, 'cards.right').focus(),
      'two places are taken away': after(async () => {
        await child.presses('cards.removePlace', { number: 3 })
        await child.presses('cards.removePlace', { number: 2 })
      }),
      'a further place': after(() => child.presses('cards.addPlace')),
      'the place where Bo stands': after(() => child.presses('cards.takePlace')),
      'as many places as there may be': after(() =>
        child.button('cards.addPlace').evaluate((button: HTMLElement) => {
          for (let left = 5; left > 0; left -= 1) button.click()
        }),
      ),
      'one place again': after(async () => {
        for (let left = 7; left > 0; left -= 1) await child.presses('cards.removePlace', { number: 2 })
      }),
      async 'all blocks are offered'() {
        await named('combobox', 'cards.level').selectOption('all')
        await page.getByRole('checkbox').first().click()
        await tried()
      },
      async 'the plain toolbox is offered'() {
        await named('combobox', 'cards.level').selectOption('plain')
        await tried()
      },
      'children begin with the start block': after(() => begins(1)),
      'children begin with another program': after(() => begins(other)),
      'children begin without the solution': after(() => begins(0)),
      'a wrong answer is not refused': after(() => addsWrong('Other')),
      'it is taken away': after(() => removes('cards.removeWrong')),
      'this program is a wrong answer': after(() => addsWrong(child.word('cards.addWrongNow'))),
      'only the last of its goals stays': after(async () => {
        const goals = page.locator('.check')
        while ((await goals.count()) > 1) await goals.first().getByRole('button').click()
      }),
      'a goal that Bo does not reach': after(() => adds('arrives')),
      'the goal has other numbers': after(async () => {
        await types(named('spinbutton', 'cards.number.x').last(), '9999')
        await types(named('spinbutton', 'cards.number.cm').last(), '9')
        await named('combobox', 'cards.number.after').selectOption({ index: 1 })
      }),
      'a goal of places': after(() => adds('visits')),
      async 'its places are odd'() {
        await types(page.getByRole('textbox', { name: child.word('cards.points') }), 'here')
      },
      'its places are right': after(() =>
        types(page.getByRole('textbox', { name: child.word('cards.points') }), '70 40, 190 40'),
      ),
      'goals of things and words': after(async () => {
        for (let left = 2; left > 0; left -= 1) await removes('cards.removeCheck')
        await adds('near')
        await adds('says')
      }),
      'they are about other colours': after(async () => {
        const colours = page.getByRole('group', { name: child.word('cards.number.others'), exact: true })
        await colours.getByRole('checkbox').first().click()
        await named('combobox', 'cards.number.colour').last().selectOption({ index: 2 })
      }),
      'the goals are taken away': after(async () => {
        for (let left = 2; left > 0; left -= 1) await removes('cards.removeCheck')
        await removes('cards.removeWrong')
      }),
      async 'it is shared as a link'() {
        await saves('cards.saveFile')
        await saves('cards.saveWhole')
        await child.presses('cards.shareLink')
      },
      'the link is closed': () => child.types('Escape'),
      'all cards of this device': () => child.presses('cards.title'),
      'the making goes on': () => link(child, 'cards.edit').click(),
      'it is among the cards': () => child.presses('cards.putOnShelf'),
      'it is shared from there': () => child.presses('cards.shareLink'),
      async 'it is printed'() {
        await child.types('Escape')
        await link(child, 'cards.print').click()
        await expect(page.locator('.own-card[aria-busy=false] svg path[d]').first()).toBeAttached()
      },
    },
    { hides: /\?p=[\w-]+|open#[\w.-]+/g },
  )
  // By address: a link to a card of another device.
  await page.goto('/cards?p=elsewhere')
  await expect(child.words('cards.missing')).toBeVisible()
})
