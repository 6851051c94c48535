// Rooms: class
import { Pupil } from '../child-class.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn } from '../made-class.ts'

const test = testInClass('de')
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

test.use({ language: 'de' })

test('a child with nothing but a finger joins, and comes back by its pictures', async ({
  child,
  page,
  school,
}) => {
  const pupil = new Pupil(child, school)
  await pupil.opensByLink()
  await pupil.nickname.fill('Fuchs')
  await child.button('class.join').tap()
  await expect(child.words('class.helloPictures', { nickname: 'Fuchs' })).toBeFocused()
  const pictures = await page.getByRole('listitem').locator('b').allInnerTexts()
  await child.button('class.remembered').tap()
  await pupil.me.tap()
  await child.button('class.leave').tap()
  await page
    .getByRole('dialog')
    .getByRole('button', { name: child.word('class.leave'), exact: true })
    .tap()
  await expect(child.words('class.joinTitle')).toBeVisible()
  await pupil.opensByLink()
  await child.button('class.wasThere').tap()
  await pupil.nickname.fill('Fuchs')
  await child.button('class.next').tap()
  for (const name of pictures) await page.getByRole('button', { name, exact: true }).tap()
  await expect(child.words('class.workIsHere')).toBeVisible()
  await child.button('class.toGarden').tap()
  await pupil.seesMe()
})

test('a finger puts a hint away and takes a program', async ({ child, page, school }) => {
  const pupil = await joins(school, 'Kiwi')
  const send = (more: object) =>
    school.teacher.ask('POST', `/classes/${school.id}/handouts`, { to: [pupil.id], ...more })
  await signsIn(page, school, pupil)
  await child.opensLab('friendship')
  await send({ kind: 'hint', text: 'Schau auf das linke Rad.' })
  await expect(page.getByText('Schau auf das linke Rad.')).toBeVisible()
  await child.button('class.putAway').tap()
  await send({ kind: 'program', card: 'fear' })
  await child.button('class.openOffer').tap()
  await expect(page).toHaveURL(/lab\/fear\?p=fear-/)
})
