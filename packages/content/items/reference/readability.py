"""Reference values of the 4. Wiener Sachtextformel by textstat 0.7.13: python readability.py > readability.json"""
import json
import textstat
textstat.set_lang("de")
texts = [
    "Bo hat ein blaues Quadrat entdeckt. Bo soll nah herankommen und dort bleiben, wie es gute Freunde tun.",
    "Die Wissenschaft untersucht seit Jahrzehnten, wie Maschinen aus Erfahrungen lernen. Verschiedene Verfahren unterscheiden sich erheblich.",
]
rows = []
for text in texts:
    rows.append({
        "text": text,
        "sentences": textstat.sentence_count(text),
        "words": textstat.lexicon_count(text),
        "long": textstat.polysyllabcount(text),
        "grade": textstat.wiener_sachtextformel(text, variant=4),
    })
print(json.dumps({"sachtext": rows}, indent=2, ensure_ascii=False))
