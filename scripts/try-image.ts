// `npm run image:try`: starts the image in QEMU's machine `virt` and does with it what a room does: first start, lesson,
// ten power cuts during saves, a full card, updates. Without KVM that takes an hour. `-- cuts updates` does these parts, each
// of which goes on from the lesson that the first start led to; `-- --same-lesson cuts` from that of the last time.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync, mkdirSync, truncateSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { setTimeout as after } from 'node:timers/promises'
import root from '../package.json' with { type: 'json' }
import { fromBoot, startGuest, toBoot, untilLabAnswers, type Card, type Guest } from './image/guest.ts'
import { copyCard, keepLesson, lessonFor, lostOnCard, siteOf, type Lesson } from './image/lesson.ts'
import { lostOf, openLesson, saveOnce, saveUntilCut } from './image/pupils.ts'
import { onStick, plugIn, pullOut, stickThatAsks, stickWith } from './image/stick.ts'
import { missing, toTry } from './image/tools.ts'
import { inHouse } from './prepare/house.mjs'
import { asScript, Trouble } from './prepare/run.mjs'

const made = inHouse('build', 'image')
const name = `botgarten-pi-${root.version}`
const work = join(made, 'try')
const cuts = 10
const began = Date.now()

/** Says what holds, once it does. */
async function holds(sentence: string, check: () => Promise<unknown> | void) {
  await check()
  console.log(`${String(Math.round((Date.now() - began) / 1000)).padStart(5)} s  ✓ ${sentence}`)
}

async function start(card: Card, slot: string): Promise<Guest> {
  const guest = startGuest(card)
  assert.equal(guest.slot, slot)
  const seconds = await untilLabAnswers(card, guest)
  console.log(`         (system ${slot}, the lab answers after ${seconds} s)`)
  return guest
}

/** Asks until something is so, for ten minutes. */
async function until(guest: Guest, command: string, answer: RegExp): Promise<string> {
  let text = ''
  for (let tries = 0; tries < 200; tries++) {
    text = await guest.shell(command)
    if (answer.test(text)) return text
    await after(3000)
  }
  throw new Trouble(`${command}: ${text}`)
}

async function tryFirstStart(card: Card, guest: Guest): Promise<string> {
  const site = siteOf(card)
  await holds('pages, cards and what there is not are answered', async () => {
    for (const path of ['/', '/lab/free', '/teacher/start'])
      assert.equal((await fetch(site + path)).status, 200, path)
    assert.equal((await fetch(`${site}/lab/unknown`)).status, 404)
  })
  await holds('the root is read only, also for root', async () => {
    assert.match(await guest.shell('touch /etc/botgarten /opt/x'), /Read-only file system[^]*Read-only/)
  })
  await holds('the data partition has taken the rest of a card of 8 GB', async () => {
    const blocks = Number(await guest.shell('df -B1M --output=size /var/lib/botgarten | tail -n 1'))
    assert.ok(blocks > 3500, String(blocks))
  })
  await holds('it is called botgarten, also by its local name', async () => {
    assert.equal(await guest.shell('uname -n'), 'botgarten')
    await until(guest, 'getent hosts botgarten.local', /botgarten\.local/)
  })
  await holds('the lab runs as a user without rights, and systemd watches it', async () => {
    assert.match(
      await guest.shell('systemctl show -p User,WatchdogUSec,NoNewPrivileges botgarten'),
      /User=botgarten/,
    )
    assert.equal(
      await guest.shell("stat -c '%U' /proc/$(pgrep -f apps/cli/botgarten | head -n 1)"),
      'botgarten',
    )
    await until(guest, 'systemctl is-active botgarten', /^active$/)
  })
  await holds('no unit failed', async () => {
    assert.equal(await guest.shell('systemctl --failed --plain --no-legend'), '')
  })
  let token = ''
  await holds('the link for the first teacher is on the screen and on the boot partition', async () => {
    await until(guest, 'cat /dev/vcs1', /teacher\/start#/)
    token = (await guest.shell('cat /var/lib/botgarten/lab/first-teacher.txt')).split('#')[1]!
    assert.ok((await guest.shell('cat /dev/vcs1')).includes(token))
    assert.equal(fromBoot(card, 'first-teacher.txt')?.trim().split('#')[1], token)
    await guest.monitor(`screendump ${join(made, 'first-screen.png')} -f png`)
  })
  await holds('a stick that asks for the link gets it', async () => {
    const stick = stickThatAsks(join(work, 'asks.img'), 'first-teacher.txt')
    await plugIn(guest, stick)
    for (let tries = 0; tries < 300 && onStick(stick, 'first-teacher.txt') === ''; tries++) await after(1000)
    assert.ok(onStick(stick, 'first-teacher.txt').includes(token))
    await pullOut(guest)
  })
  return token
}

async function tryHotspot({ card, guest }: Lesson) {
  const password = fromBoot(card, 'hotspot.txt')!.trim().split(/\r?\n/)[1]!
  await holds('the hot spot has a password made at the first start', () =>
    assert.match(password, /^[a-z346789]{4}(-[a-z346789]{4}){2}$/),
  )
  await guest.shell('modprobe mac80211_hwsim radios=2')
  await holds('with a radio (mac80211_hwsim) the hot spot sends', async () => {
    await until(guest, 'nmcli -t -f NAME,DEVICE,STATE connection show --active', /Botgarten:wlan0:activated/)
    const radio = await guest.shell('iw dev wlan0 info')
    assert.match(radio, /ssid Botgarten/)
    assert.match(radio, /type AP/)
    assert.match(await guest.shell('iw reg get'), /country DE/)
  })
  await holds('a device joins by WPA2 and gets an address; a wrong password does not', async () => {
    const security = 'wifi-sec.key-mgmt wpa-psk'
    const join = (word: string) =>
      `nmcli connection add save no type wifi ifname wlan1 con-name ${word} autoconnect no ssid Botgarten ${security} ` +
      `wifi-sec.psk ${word} >/dev/null; nmcli --wait 90 connection up ${word}`
    assert.match(await guest.shell(join('wrong-password')), /Error/)
    assert.match(await guest.shell(join(password)), /successfully activated/)
    assert.match(await guest.shell('ip -4 -o address show wlan1'), / 10\.42\.0\.\d+/)
  })
  await holds('the screen says its name, password and address', async () => {
    await guest.shell('systemctl start botgarten-screen')
    const screen = await guest.shell('cat /dev/vcs1')
    assert.ok(screen.includes(password) && screen.includes('http://10.42.0.1'))
    await guest.monitor(`screendump ${join(made, 'hotspot-screen.png')} -f png`)
  })
  await guest.cut()
}

async function tryFullCard({ guest, pupils }: Lesson) {
  const [pupil] = pupils
  let status: number | null = 200
  await holds('on a full card a save is refused in words, and the teacher is told', async () => {
    const folder = '/var/lib/botgarten'
    await guest.shell(
      `cd ${folder}; fallocate -l $(df -B1 --output=avail . | tail -n 1) filler; cat /dev/zero > rest; sync`,
    )
    // What the database has written already is written again for some saves.
    for (let tries = 0; tries < 400 && status !== 507; tries++) status = await saveOnce(pupil!)
    assert.equal(status, 507)
    await guest.shell('systemctl start botgarten-screen')
    assert.match(await guest.shell('cat /dev/vcs1'), /Die Karte ist voll/)
  })
  await holds('with room again saves go on', async () => {
    await guest.shell('cd /var/lib/botgarten; rm filler rest; sync')
    // An emulated Pi on a busy machine may take longer to check a project than is allowed.
    for (let tries = 0; tries < 60 && status !== 200; tries++) status = await saveOnce(pupil!)
    assert.equal(status, 200)
    assert.equal(await lostOf(pupil!), 0)
  })
  await guest.cut()
}

/** Pulls the plug some seconds after the first saves. @returns how many were acknowledged */
async function cutDuringSaves({ guest, pupils }: Lesson): Promise<number> {
  const before = pupils.map(({ acknowledged }) => acknowledged)
  const saving = Promise.all(pupils.map(saveUntilCut))
  while (pupils.every(({ acknowledged }, at) => acknowledged === before[at])) await after(100)
  await after(Math.random() * 12_000)
  await guest.cut()
  return (await saving).reduce((sum, one) => sum + one, 0)
}

/** Each cut is one in the kept lesson, at another moment. What is on the card is read here; after the last one the Pi starts. */
async function tryCuts(first: Lesson) {
  let lesson = first
  for (let cut = 1; cut < cuts; cut++) {
    const saves = await cutDuringSaves(lesson)
    await holds(
      `power cut ${cut} during saves: none of ${saves} that were acknowledged is lost`,
      async () => {
        assert.ok(saves > 0)
        assert.equal(await lostOnCard(lesson), 0)
      },
    )
    lesson = await again(lesson)
  }
  const { card, pupils } = lesson
  const saves = await cutDuringSaves(lesson)
  writeFileSync(join(work, 'reset.txt'), 'm.weber\r\n')
  toBoot(card, join(work, 'reset.txt'), 'reset-teacher.txt')
  const guest = await start(card, 'a')
  await holds(`power cut ${cuts}: the Pi starts by itself, and none of ${saves} is lost`, async () => {
    for (const pupil of pupils) assert.equal(await lostOf(pupil), 0)
    assert.equal(await saveOnce(pupils[0]!), 200)
  })
  await holds('a name in reset-teacher.txt on the boot partition gives a new password there', async () => {
    await until(guest, 'systemctl start botgarten-screen; cat /dev/vcs1', /Neues Passwort/)
    assert.match(fromBoot(card, 'new-password.txt') ?? '', /^[a-z]+(-[a-z]+){3}\s*$/)
    assert.equal(fromBoot(card, 'reset-teacher.txt'), null)
  })
  await guest.cut()
}

/** An update whose lab does not start. */
function brokenUpdate(): string {
  const [folder, file] = [join(work, 'broken'), join(work, `botgarten-pi-broken.update`)]
  mkdirSync(folder, { recursive: true })
  execFileSync('tar', ['-xf', join(made, `${name}.update`), '-C', folder])
  execFileSync('zstd', ['-q', '-d', '-f', join(folder, 'root.img.zst'), '-o', join(work, 'broken.img')])
  execFileSync('debugfs', ['-w', '-R', 'rm /opt/botgarten/app/complete', join(work, 'broken.img')], {
    stdio: 'ignore',
  })
  execFileSync('zstd', ['-q', '-f', '-1', join(work, 'broken.img'), '-o', join(folder, 'root.img.zst')])
  execFileSync('sh', ['-c', 'tar -cf "$1" -C "$2" $(ls "$2")', 'tar', file, folder])
  return file
}

async function restarted(guest: Guest) {
  const ended = await Promise.race([guest.ended.then(() => true), after(2_400_000, false, { ref: false })])
  if (!ended) throw new Trouble(`The guest did not start again.\n${guest.output().slice(-2000)}`)
}

async function tryUpdates({ card, guest: first, pupils }: Lesson) {
  let guest = first
  const good = join(made, `${name}.update`)
  await holds('an update without a teacher’s word, or with a wrong checksum, is only spoken of', async () => {
    const stick = await stickWith(join(work, 'stick.img'), good, 'none')
    await plugIn(guest, stick)
    await until(guest, 'cat /dev/vcs1', /SHA256SUMS/)
    await pullOut(guest)
    await plugIn(guest, await stickWith(join(work, 'stick.img'), good, 'wrong'))
    await until(guest, 'cat /dev/vcs1', /stimmt nicht/)
    await pullOut(guest)
    assert.equal(fromBoot(card, 'slot.txt'), 'os_prefix=a/\n')
  })
  await holds(
    'an update from a stick goes to the other system, which starts, tries itself and stays',
    async () => {
      await plugIn(guest, await stickWith(join(work, 'stick.img'), good, 'right'))
      await restarted(guest)
      guest = await start(card, 'b')
      assert.equal(fromBoot(card, 'trial.txt')?.trim(), 'kept b')
      assert.equal(fromBoot(card, 'slot.txt'), 'os_prefix=b/\n')
      for (const pupil of pupils) assert.equal(await lostOf(pupil), 0)
    },
  )
  await holds('an update whose lab does not start is taken back, and nothing is lost', async () => {
    await plugIn(guest, await stickWith(join(work, 'stick.img'), brokenUpdate(), 'right'))
    await restarted(guest)
    guest = startGuest(card)
    assert.equal(guest.slot, 'a')
    await restarted(guest)
    guest = await start(card, 'b')
    assert.equal(fromBoot(card, 'trial.txt')?.trim(), 'failed a')
    await until(guest, 'cat /dev/vcs1', /System davor/)
    for (const pupil of pupils) assert.equal(await lostOf(pupil), 0)
    assert.equal(await saveOnce(pupils[0]!), 200)
  })
  await guest.cut()
}

const tries = { hotspot: tryHotspot, full: tryFullCard, cuts: tryCuts, updates: tryUpdates }
const names = Object.keys(tries) as (keyof typeof tries)[]
/** Not 4190, which no `fetch` calls. */
const lessonOf = (name: keyof typeof tries) => lessonFor(name, 4201 + names.indexOf(name), work)
const again = ({ card }: Lesson) => lessonFor('cuts', card.port, work)

/** A fresh card of 8 GB, the first start, and a lesson that is kept. */
async function firstStart() {
  const card = { file: join(work, 'card.img'), work: join(work, 'first'), port: 4187 }
  copyCard(join(made, `${name}.img`), card.file)
  truncateSync(card.file, 8_000_000_000)
  const guest = await start(card, 'a')
  const token = await tryFirstStart(card, guest)
  const pupils = await openLesson(siteOf(card), token, 5)
  await holds('a teacher is made, and the link is gone from the boot partition', async () => {
    await until(guest, 'systemctl start botgarten-screen; cat /dev/vcs1', /Botgarten(?![^]*teacher\/start)/)
    assert.equal(fromBoot(card, 'first-teacher.txt'), null)
  })
  await keepLesson({ card, guest, pupils }, work)
}

await asScript(async () => {
  const lacking = missing(toTry)
  if (lacking !== null) throw new Trouble(lacking)
  if (!existsSync(join(made, `${name}.img`)))
    throw new Trouble('There is no image yet: npm run image -- --quick')
  mkdirSync(work, { recursive: true })
  const same = process.argv.includes('--same-lesson')
  const wanted = process.argv.slice(2).filter((one) => !one.startsWith('--'))
  if (!same) await firstStart()
  for (const part of names.filter((one) => wanted.length === 0 || wanted.includes(one)))
    await tries[part](await lessonOf(part))
  return 0
})
