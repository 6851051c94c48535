import { randomInt } from 'node:crypto'

/** Without look-alikes: 29 letters, so that twelve of them are 58 bits. */
const letters = 'abcdefghjkmnpqrstuvwxyz346789'

/** A password that can be read from a screen and typed: `abcd-efgh-jkmn`. @param pick a whole number below its argument */
export function newPassword(pick: (below: number) => number = randomInt): string {
  const four = () => Array.from({ length: 4 }, () => letters[pick(letters.length)]!).join('')
  return [four(), four(), four()].join('-')
}

/** Values of keyfiles: `\` stands before a letter with a meaning, and leading blanks would be cut. */
const escaped = (text: string) => text.replaceAll('\\', '\\\\').replace(/^ /, '\\s')

/** The address of the Pi in its own hot spot. */
export const ownAddress = '10.42.0.1'

/**
 * The hot spot as a keyfile of NetworkManager (nm-settings-keyfile). The name stands there in bytes, since no letter of
 * it can then mean anything else.
 */
export const hotspotProfile = (name: string, password: string): string => `[connection]
id=Botgarten
uuid=6c2b7e0e-54a5-4b6f-9f0e-b07a9a27e001
type=wifi
interface-name=wlan0
autoconnect=true
autoconnect-retries=0

[wifi]
mode=ap
ssid=${[...Buffer.from(name)].map((byte) => `${byte};`).join('')}
band=bg
channel=6

[wifi-security]
key-mgmt=wpa-psk
proto=rsn;
pairwise=ccmp;
group=ccmp;
pmf=1
psk=${escaped(password)}

[ipv4]
method=shared
address1=${ownAddress}/24

[ipv6]
method=disabled
`

const escapedInCode = (text: string) => text.replaceAll(/[\\;,:"]/g, (letter) => `\\${letter}`)

/** What phones read from a code to join a Wi-Fi. */
export const joinCode = (name: string, password: string): string =>
  `WIFI:T:WPA;S:${escapedInCode(name)};P:${escapedInCode(password)};;`
