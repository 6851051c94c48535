import { Pupil } from '../child-class.ts'
import { leftEye, leftWheel } from '../child.ts'
import { projectFile } from '../projects.ts'
import { expect, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({
  language: 'en',
  complaints: [/^A request to http:\/\/laptop\.localhost:\d+\/|net::ERR_FAILED|status of 404/],
})

/** Under an old name of the server, which announces another one. Browsers resolve `*.localhost` to this machine. */
test(
  'the way to the announced address, step by step',
  { tag: '@address' },
  async ({ child, page, school, house }) => {
    const before = `http://laptop.localhost:${new URL(house).port}`
    const fox = new Pupil(child, school)
    const dialog = page.getByRole('dialog')
    const says = (key: string, facts = {}) =>
      expect(dialog).toContainText(child.word(`address.${key}`, facts))
    const saves = '**/api/class/projects/**'
    let announced = 'http://garden.example'
    await page.route('**/api/class/state', (route) => route.fulfill({ json: { address: announced } }))
    /** Opens the page again. A tab remembers that the child stays. */
    const comes = async (path = '/') => {
      await page.evaluate(() => sessionStorage.removeItem('botgarten.stays'))
      await page.goto(before + path)
    }
    await page.goto(`${before}/`)
    await goesThrough(
      child,
      'address',
      {
        'nothing is kept here': () => says('nothing'),
        'the child stays': () => child.presses('address.stay'),
        'work is kept here': async () => {
          await child.opensFileAtHome('Friendship.botgarten.json', projectFile('friendship', 'start'))
          await child.seesLab()
          await comes()
          await says('alone', { count: 1 })
        },
        'it is taken home': () =>
          Promise.all([page.waitForEvent('download'), child.presses('address.takeHome')]),
        'the sheet is left by a key': () => child.types('Escape'),
        'all is in the class': async () => {
          await comes(`/join#${school.code.replaceAll(' ', '-')}`)
          await child.presses('address.stay')
          await fox.joins('Fuchs')
          await fox.remembers()
          announced = 'https://garden.example'
          await comes()
          await says('allInClass')
        },
        'how to trust': () => page.getByRole('link', { name: child.word('address.trustHow') }).click(),
        'work waits': async () => {
          await page.route(saves, (route) => route.abort())
          await comes()
          await child.presses('address.stay')
          await child.opensLab('friendship')
          await child.typesWeight(leftEye, leftWheel, 0.7)
          await expect(fox.chip('chipHere')).toBeVisible()
          await comes()
          await says('waiting', { count: 1 })
        },
        'it cannot be sent': () => child.presses('address.send'),
        'it is sent': async () => {
          await page.unroute(saves)
          await child.presses('address.send')
          await says('allInClass')
        },
      },
      { hides: /(?<=\?p=)[\w-]+|(?<=laptop\.)localhost(?::\d+)?/g },
    )
  },
)
