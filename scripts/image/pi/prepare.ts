// Before the lab starts: settings and wishes from the boot partition, and the hot spot, whose password is made once.
import { chmodSync, chownSync, existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { hotspotProfile, newPassword } from './hotspot.ts'
import { data, here, keepSettings, lab, labUser, readBoot, run, textIn, writeBoot } from './machine.ts'
import { readSettings, type Settings } from './settings.ts'
import { readTrial, taskOf } from './slots.ts'

const [reset, password] = ['reset-teacher.txt', `${data}/hotspot-password`]

function passwordFor({ password: wanted }: Settings): string {
  if (wanted !== '') return wanted
  const made = textIn(password)?.trim()
  if (made) return made
  const fresh = newPassword()
  writeFileSync(password, `${fresh}\n`, { mode: 0o600, flush: true })
  return fresh
}

function keepHotspot(settings: Settings) {
  const folder = '/run/NetworkManager/system-connections'
  mkdirSync(folder, { recursive: true })
  const file = join(folder, 'botgarten.nmconnection')
  writeFileSync(file, hotspotProfile(settings.hotspot, settings.password))
  chmodSync(file, 0o600)
  try {
    run('modprobe', 'cfg80211', `ieee80211_regdom=${settings.country}`)
    run('iw', 'reg', 'set', settings.country)
  } catch {
    console.error(`The rules of ${settings.country} could not be set.`)
  }
}

/** A teacher's name in a file asks for a new password: the lab reads it from its own folder. */
function takeReset(name: string) {
  const file = join(lab, reset)
  writeFileSync(file, name, { mode: 0o600 })
  chownSync(file, labUser, labUser)
  writeBoot((folder) => rmSync(join(folder, reset)))
}

const { text, asked, trial } = readBoot((folder) => ({
  text: textIn(join(folder, 'botgarten.txt')) ?? '',
  asked: textIn(join(folder, reset)),
  trial: readTrial(textIn(join(folder, 'trial.txt')) ?? ''),
}))
const wanted = readSettings(text)
if (!existsSync(lab)) mkdirSync(lab, { mode: 0o700 })
chownSync(lab, labUser, labUser)
const settings = { ...wanted, password: passwordFor(wanted) }
keepSettings(settings)
keepHotspot(settings)
if (asked !== null) takeReset(asked)
if (taskOf(here.slot, trial) !== 'nothing') writeFileSync('/run/botgarten/trial', '')
const wifi = '/run/botgarten/wifi.json'
writeFileSync(wifi, JSON.stringify({ name: settings.hotspot, password: settings.password }))
chownSync(wifi, labUser, labUser)
const environment = [
  `BOTGARTEN_LANGUAGE=${settings.language}`,
  `BOTGARTEN_FLAGS=${settings.https ? '--https' : ''}`,
  `BOTGARTEN_WIFI=${wifi}`,
]
writeFileSync('/run/botgarten/lab.env', `${environment.join('\n')}\n`)
