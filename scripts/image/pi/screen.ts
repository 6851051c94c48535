// Says on the screen and on the boot partition how the lab is reached, whenever that has changed.
import { rmSync, statfsSync, writeFileSync } from 'node:fs'
import { networkInterfaces } from 'node:os'
import { join } from 'node:path'
import { ownAddress } from './hotspot.ts'
import { lab, readBoot, settings, show, textIn, writeBoot } from './machine.ts'
import { readTrial } from './slots.ts'
import { halved, screenText, teacherLink, type ScreenFacts } from './text.ts'

const terminal: string = '/opt/botgarten/app/node_modules/@botgarten/server/terminal.js'
const { codeInTerminal } = (await import(terminal)) as { codeInTerminal: (link: string) => string }

const remembered = '/run/botgarten/screen.json'
const { hotspot: name, password, language } = settings()

const addresses = Object.values(networkInterfaces())
  .flatMap((list) => list ?? [])
  .filter(({ family, internal }) => family === 'IPv4' && !internal)
  .map(({ address }) => address)

function room(): number {
  const { bavail, bsize } = statfsSync(lab)
  return Math.floor((bavail * bsize) / 1e6)
}

const token = textIn(join(lab, 'first-teacher.txt'))?.trim().split('#')[1] ?? null
const newPassword = textIn(join(lab, 'new-password.txt'))
const answers = await fetch('http://127.0.0.1/https.json').then(
  ({ status }) => status < 500,
  () => false,
)

/** What lies on the boot partition for who reads the card on another computer; null: is not to lie there. */
const files: Record<string, string | null> = {
  'first-teacher.txt': token === null ? null : `${teacherLink(addresses, ownAddress, token)}\n`,
  'hotspot.txt': `${name}\n${password}\n`,
  'new-password.txt': newPassword,
}

function keepFiles(folder: string) {
  for (const [file, text] of Object.entries(files)) {
    if (text === null) rmSync(join(folder, file), { force: true })
    else if (textIn(join(folder, file)) !== text) writeFileSync(join(folder, file), text)
  }
}

const state = readTrial(readBoot((folder) => textIn(join(folder, 'trial.txt'))) ?? '')?.state
const facts: ScreenFacts = {
  ...{ language, hotspot: { name, password }, addresses, token, started: answers },
  ...{ passwordMade: newPassword !== null, room: room() },
  trial: state === 'kept' || state === 'failed' ? state : null,
}
const now = JSON.stringify({ ...facts, room: Math.floor(facts.room / 10), files })
if (textIn(remembered) !== now) {
  writeBoot(keepFiles)
  show(screenText(facts, ownAddress, (link) => halved(codeInTerminal(link))))
  writeFileSync(remembered, now)
}
