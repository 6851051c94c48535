export { readFreeText } from '@botgarten/materials'
