import { Pupil } from '../child-class.ts'
import { leftEye, leftWheel } from '../child.ts'
import { expect, link, test } from './gate.ts'

test.use({ language: 'en' })

test(
  'a pupil joins by the code, works in the class, leaves, and finds its work again by three pictures',
  {
    tag: ['@class', '@/join'],
  },
  async ({ child, page, school }) => {
    const fox = new Pupil(child, school)
    await child.opensHome()
    await link(child, 'home.joinClass').click()
    await expect(child.words('class.joinTitle')).toBeVisible()
    await page.keyboard.type(`${school.code} `)
    await expect(fox.nickname).toBeFocused()
    const pictures = await fox.joins('Fuchs')
    expect(pictures).toHaveLength(3)
    await fox.remembers()

    await child.opensLab('friendship')
    await child.typesWeight(leftEye, leftWheel, 0.8)
    await expect(fox.chip('chipClass')).toBeVisible()
    const body = async () => (await school.teacher.ask('GET', `/classes/${school.id}`)).body
    await expect.poll(body).toMatchObject({ projects: 1 })
    await fox.leaves()

    await page.keyboard.type(`${school.code} `)
    await fox.returns('Fuchs')
    await fox.taps(...pictures)
    await expect(child.words('class.workIsHere')).toBeVisible()
    await child.presses('class.toGarden')
    await child.opensLab('friendship')
    await child.seesWeight(leftEye, leftWheel, 0.8)
  },
)
